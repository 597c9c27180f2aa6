#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/cursor.h"
#include "io/scalar_type.h"
#include "io/vtk_xml_data.h"

namespace nearwall::io {

/// A start tag with its attributes.
struct XmlTag {
  std::string_view name;
  std::map<std::string_view, std::string_view> attributes;
  std::size_t content = 0;  ///< offset of the first byte behind it

  std::string_view attribute(std::string_view key) const {
    const auto found = attributes.find(key);
    return found == attributes.end() ? std::string_view() : found->second;
  }
};

/// A <DataArray> or <Array> of a VTK XML file.
struct XmlArray {
  std::size_t piece = 0;     ///< index into VtkXmlInput::pieces
  std::string_view section;  ///< the element it stands in: Points, Polys, CellData ...
  XmlTag tag;

  std::string_view name() const { return tag.attribute("Name"); }
};

/// Where the values of an array go, run by run.
template <class T>
using TakeRun = std::function<void(std::span<const T>)>;

/// The structure of a VTK XML file (PolyData, UnstructuredGrid) and the numbers of its arrays, in all encodings that
/// VTK's writers make: ascii, base64 and appended, raw or base64, plain or zlib. Positions in messages are bytes.
class VtkXmlInput {
 public:
  /// Reads the tags. The bytes must outlive it.
  VtkXmlInput(std::string_view bytes, std::string file);

  std::string_view type() const { return type_; }  ///< attribute of <VTKFile>
  const std::vector<XmlTag>& pieces() const { return pieces_; }
  const std::vector<XmlArray>& arrays() const { return arrays_; }
  /// A count of a piece's tag such as NumberOfPoints; 0 if there is none.
  std::int64_t count_of(std::size_t piece, std::string_view attribute) const;

  /// The values run by run, in their order: announce(n) with their number beforehand, unless they are ascii, then
  /// take(run) for each run. Never more in memory than some blocks of the file.
  using Announce = std::function<void(std::size_t)>;
  void read_reals(const XmlArray& array, const Announce& announce, const TakeRun<double>& take) const;
  void read_integers(const XmlArray& array, const Announce& announce, const TakeRun<std::int64_t>& take) const;

  /// The same, whole.
  std::vector<double> reals(const XmlArray& array) const;
  std::vector<std::int64_t> integers(const XmlArray& array) const;
  /// Strings, each with a zero behind it.
  std::vector<std::string> strings(const XmlArray& array) const;

  Cursor at(const XmlArray& array) const;

 private:
  void read_tags();
  bool next_tag(XmlTag& tag, bool& is_end, bool& is_closed);
  void read_attributes(XmlTag& tag, std::string_view text);
  void open(const XmlTag& tag);
  void read_file_tag(const XmlTag& tag);
  XmlData data_of(const XmlArray& array) const;
  template <class T>
  void read_ascii(Cursor where, const TakeRun<T>& take) const;
  template <class T>
  void read_values(const XmlArray& array, const Announce& announce, const TakeRun<T>& take) const;
  template <class T>
  std::vector<T> values(const XmlArray& array) const;

  Cursor in_;
  std::string_view type_;
  XmlEncoding encoding_;      // of appended arrays; inline ones are base64
  std::size_t appended_ = 0;  // offset behind the underscore; 0: none
  std::vector<std::string_view> open_;
  std::vector<XmlTag> pieces_;
  std::vector<XmlArray> arrays_;
};

}  // namespace nearwall::io
