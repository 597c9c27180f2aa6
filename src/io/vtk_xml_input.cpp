#include "io/vtk_xml_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace nearwall::io {
namespace {

ScalarType scalar_type(std::string_view name) {
  if (name == "Int8" || name == "String") return ScalarType::Int8;
  if (name == "UInt8") return ScalarType::UInt8;
  if (name == "Int16") return ScalarType::Int16;
  if (name == "UInt16") return ScalarType::UInt16;
  if (name == "Int32") return ScalarType::Int32;
  if (name == "UInt32") return ScalarType::UInt32;
  if (name == "Int64") return ScalarType::Int64;
  if (name == "UInt64") return ScalarType::UInt64;
  if (name == "Float32") return ScalarType::Float32;
  if (name == "Float64") return ScalarType::Float64;
  return ScalarType::None;
}

/// Decodes `bytes`, whole values of `type`, as values of T and hands them on in runs.
template <class T>
void decode_runs(std::string_view bytes, ScalarType type, std::endian order, const TakeRun<T>& take) {
  constexpr std::size_t kRun = 4096;
  std::vector<T> run;
  with_type(type, [&](auto kind) {
    constexpr std::size_t kWidth = sizeof(kind);
    for (std::size_t at = 0; at < bytes.size();) {
      run.resize(std::min(kRun, (bytes.size() - at) / kWidth));
      for (T& value : run) {
        value = converted<T>(Cursor::decode<decltype(kind)>(bytes.data() + at, order));
        at += kWidth;
      }
      take(run);
    }
  });
}

}  // namespace

VtkXmlInput::VtkXmlInput(std::string_view bytes, std::string file) : in_(bytes, std::move(file)) {
  in_.enter_binary();
  read_tags();
  if (type_.empty()) in_.fail("expected <VTKFile>, found none: this is no VTK XML file");
}

void VtkXmlInput::read_tags() {
  XmlTag tag;
  bool is_end = false, is_closed = false;
  while (appended_ == 0 && next_tag(tag, is_end, is_closed)) {
    if (is_end) {
      if (open_.empty() || open_.back() != tag.name) in_.fail(fmt::format("unexpected </{}>", quoted(tag.name)));
      open_.pop_back();
      continue;
    }
    open(tag);
    if (!is_closed) open_.push_back(tag.name);
  }
}

/// The next start or end tag; comments and declarations are passed.
bool VtkXmlInput::next_tag(XmlTag& tag, bool& is_end, bool& is_closed) {
  const std::string_view all = in_.all();
  for (;;) {
    const std::size_t begin = all.find('<', in_.offset());
    if (begin == std::string_view::npos) return false;
    in_.seek(begin);
    const bool is_comment = all.substr(begin).starts_with("<!--");
    const std::string_view closing = is_comment ? "-->" : ">";
    const std::size_t end = all.find(closing, begin);
    if (end == std::string_view::npos) in_.fail("a tag that does not end");
    if (is_comment || all.substr(begin).starts_with("<?") || all.substr(begin).starts_with("<!")) {
      in_.seek(end + closing.size());
      continue;
    }
    std::string_view text = all.substr(begin + 1, end - begin - 1);
    is_end = text.starts_with('/');
    is_closed = text.ends_with('/');
    if (is_end) text.remove_prefix(1);
    if (is_closed && !text.empty()) text.remove_suffix(1);
    tag = XmlTag();
    read_attributes(tag, trimmed(text));
    in_.seek(end + 1);
    tag.content = in_.offset();
    return true;
  }
}

void VtkXmlInput::read_attributes(XmlTag& tag, std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  tag.name = text.substr(0, text.find_first_of(kBlanks));
  text = trimmed(text.substr(tag.name.size()));
  while (!text.empty()) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) in_.fail_expected("an attribute NAME=\"VALUE\"", text);
    const std::string_view key = trimmed(text.substr(0, equals));
    text = trimmed(text.substr(equals + 1));
    if (!text.starts_with('"') && !text.starts_with('\'')) in_.fail_expected("a value in quotes", text);
    const std::size_t end = text.find(text[0], 1);
    if (end == std::string_view::npos) in_.fail_expected("a closing quote", text);
    tag.attributes[key] = text.substr(1, end - 1);
    text = trimmed(text.substr(end + 1));
  }
}

void VtkXmlInput::open(const XmlTag& tag) {
  if (tag.name == "VTKFile") return read_file_tag(tag);
  if (tag.name == "Piece") pieces_.push_back(tag);
  if ((tag.name == "DataArray" || tag.name == "Array") && !open_.empty()) {
    arrays_.push_back({pieces_.empty() ? 0 : pieces_.size() - 1, open_.back(), tag});
  }
  if (tag.name == "AppendedData") {
    encoding_.is_base64 = tag.attribute("encoding") == "base64";
    const std::size_t underscore = in_.all().find('_', in_.offset());
    if (underscore == std::string_view::npos) in_.fail("the appended data does not begin with '_'");
    appended_ = underscore + 1;
  }
}

void VtkXmlInput::read_file_tag(const XmlTag& tag) {
  type_ = tag.attribute("type");
  encoding_.order = tag.attribute("byte_order") == "BigEndian" ? std::endian::big : std::endian::little;
  encoding_.has_wide_headers = tag.attribute("header_type") == "UInt64";
  const std::string_view compressor = tag.attribute("compressor");
  encoding_.is_compressed = !compressor.empty();
  if (encoding_.is_compressed && compressor != "vtkZLibDataCompressor") {
    in_.fail(fmt::format("data packed by {} cannot be read; save the file with zlib or without compression",
                         quoted(compressor)));
  }
}

std::int64_t VtkXmlInput::count_of(std::size_t piece, std::string_view attribute) const {
  if (piece >= pieces_.size()) return 0;
  const std::string_view text = trimmed(pieces_[piece].attribute(attribute));
  if (text.empty()) return 0;
  Cursor where = in_;
  where.seek(pieces_[piece].content);
  const std::int64_t n = where.to_integer(text, attribute);
  if (n < 0) where.fail(fmt::format("{} is {}", attribute, n));
  return n;
}

Cursor VtkXmlInput::at(const XmlArray& array) const {
  Cursor where = in_;
  where.seek(array.tag.content);
  if (array.tag.attribute("format") != "appended") return where;
  const std::int64_t offset = where.to_integer(trimmed(array.tag.attribute("offset")), "offset");
  if (appended_ == 0 || offset < 0 || static_cast<std::uint64_t>(offset) > in_.all().size() - appended_) {
    where.fail(fmt::format("array '{}' lies outside of the file (offset {})", quoted(array.name()), offset));
  }
  where.seek(appended_ + static_cast<std::size_t>(offset));
  return where;
}

XmlData VtkXmlInput::data_of(const XmlArray& array) const {
  Cursor where = at(array);
  XmlEncoding encoding = encoding_;
  if (array.tag.attribute("format") != "appended") {
    encoding.is_base64 = true;
    const std::size_t begin = where.all().find_first_not_of(" \t\r\n", where.offset());
    where.seek(std::min(begin, where.all().size()));
  }
  return {where, encoding};
}

template <class T>
void VtkXmlInput::read_ascii(Cursor where, const TakeRun<T>& take) const {
  const std::size_t end = std::min(where.all().find('<', where.offset()), where.all().size());
  Cursor text(where.all().substr(0, end), where.file());
  text.enter_binary();
  text.seek(where.offset());
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    T value;
    if constexpr (std::is_integral_v<T>) {
      value = text.to_integer(word, "a value");
    } else {
      value = text.to_number(word, "a value");
    }
    take(std::span<const T>(&value, 1));
  }
}

template <class T>
void VtkXmlInput::read_values(const XmlArray& array, const Announce& announce, const TakeRun<T>& take) const {
  const Cursor where = at(array);
  const ScalarType type = scalar_type(array.tag.attribute("type"));
  if (type == ScalarType::None) {
    where.fail_expected(fmt::format("a number type for array '{}'", quoted(array.name())), array.tag.attribute("type"));
  }
  if (array.tag.attribute("format") == "ascii") return read_ascii<T>(where, take);

  const XmlData data = data_of(array);
  const std::size_t width = size_of(type);
  if (data.n_bytes() % width != 0) where.fail(fmt::format("array '{}' ends within a value", quoted(array.name())));
  announce(static_cast<std::size_t>(data.n_bytes() / width));
  std::string split;  // the bytes so far of a value that begins in one run and ends in another
  data.for_each_run([&](std::string_view run) {
    if (!split.empty()) {
      const std::size_t missing = std::min(width - split.size(), run.size());
      split += run.substr(0, missing);
      run.remove_prefix(missing);
      if (split.size() < width) return;
      decode_runs<T>(split, type, encoding_.order, take);
    }
    const std::size_t whole = run.size() / width * width;
    split = run.substr(whole);
    decode_runs<T>(run.substr(0, whole), type, encoding_.order, take);
  });
}

void VtkXmlInput::read_reals(const XmlArray& array, const Announce& announce, const TakeRun<double>& take) const {
  read_values<double>(array, announce, take);
}

void VtkXmlInput::read_integers(const XmlArray& array, const Announce& announce,
                                const TakeRun<std::int64_t>& take) const {
  read_values<std::int64_t>(array, announce, take);
}

template <class T>
std::vector<T> VtkXmlInput::values(const XmlArray& array) const {
  std::vector<T> out;
  read_values<T>(
      array, [&](std::size_t n) { out.reserve(n); },
      [&](std::span<const T> run) { out.insert(out.end(), run.begin(), run.end()); });
  return out;
}

std::vector<double> VtkXmlInput::reals(const XmlArray& array) const { return values<double>(array); }

std::vector<std::int64_t> VtkXmlInput::integers(const XmlArray& array) const { return values<std::int64_t>(array); }

std::vector<std::string> VtkXmlInput::strings(const XmlArray& array) const {
  std::vector<std::string> out;
  std::string text;
  for (const std::int64_t code : integers(array)) {
    if (code != 0) {
      text += static_cast<char>(code);
    } else {
      out.push_back(std::exchange(text, {}));
    }
  }
  return out;
}

}  // namespace nearwall::io
