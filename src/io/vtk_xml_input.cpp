#include "io/vtk_xml_input.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <utility>

namespace nearwall::io {
namespace {

/// No deflated data grows by more on unpacking: what claims more is damaged.
constexpr std::uint64_t kMostInflation = 1040;

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

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Decodes `n` bytes at the cursor and passes their last group of four characters.
std::string take_base64(Cursor& in, std::uint64_t n) {
  const auto n_bytes = static_cast<std::size_t>(n);
  if (n > in.left()) in.fail(fmt::format("expected {} bytes in base64, found the end of the file", n));
  const std::string_view text = in.bytes((n_bytes + 2) / 3 * 4, "base64 data");
  std::string out;
  out.reserve(n_bytes + 2);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const char c = text[i + k];
      const int digit = c == '=' ? 0 : base64_digit(c);
      if (digit < 0) in.fail_expected("base64 data", text.substr(i + k, 1));
      group = group << 6 | static_cast<std::uint32_t>(digit);
    }
    for (const int shift : {16, 8, 0}) out += static_cast<char>(group >> shift & 0xff);
  }
  out.resize(n_bytes);
  return out;
}

std::string take(Cursor& in, std::uint64_t n, bool is_base64) {
  return is_base64 ? take_base64(in, n) : std::string(in.bytes(static_cast<std::size_t>(n), "data of an array"));
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
    is_appended_base64_ = tag.attribute("encoding") == "base64";
    const std::size_t underscore = in_.all().find('_', in_.offset());
    if (underscore == std::string_view::npos) in_.fail("the appended data does not begin with '_'");
    appended_ = underscore + 1;
  }
}

void VtkXmlInput::read_file_tag(const XmlTag& tag) {
  type_ = tag.attribute("type");
  order_ = tag.attribute("byte_order") == "BigEndian" ? std::endian::big : std::endian::little;
  has_wide_headers_ = tag.attribute("header_type") == "UInt64";
  const std::string_view compressor = tag.attribute("compressor");
  is_compressed_ = !compressor.empty();
  if (is_compressed_ && compressor != "vtkZLibDataCompressor") {
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

std::uint64_t VtkXmlInput::header_number(Cursor& in) const {
  return has_wide_headers_ ? in.value<std::uint64_t>(order_, "the size of an array")
                           : in.value<std::uint32_t>(order_, "the size of an array");
}

std::string VtkXmlInput::raw_bytes(const XmlArray& array, Cursor& where) const {
  const bool is_appended = array.tag.attribute("format") == "appended";
  const bool is_base64 = !is_appended || is_appended_base64_;
  if (!is_appended) {
    const std::size_t begin = where.all().find_first_not_of(" \t\r\n", where.offset());
    where.seek(std::min(begin, where.all().size()));
  }
  if (is_compressed_) return compressed_bytes(where, is_base64);
  const std::size_t width = has_wide_headers_ ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
  if (!is_base64) return take(where, header_number(where), false);
  // In base64 the size and the data are one run of characters.
  Cursor again = where;
  const std::string size_bytes = take_base64(again, width);
  Cursor size_in(size_bytes, where.file());
  const std::uint64_t n = header_number(size_in);
  if (n > where.left()) where.fail(fmt::format("an array claims {} bytes, more than the file has", n));
  return take_base64(where, n + width).substr(width);
}

/// Number of blocks, size of a block, size of the last one (0: whole), packed sizes; then the blocks.
std::string VtkXmlInput::compressed_bytes(Cursor& where, bool is_base64) const {
  const std::size_t width = has_wide_headers_ ? sizeof(std::uint64_t) : sizeof(std::uint32_t);
  Cursor peek = where;
  const std::string first = take(peek, width, is_base64);
  Cursor first_in(first, where.file());
  const std::uint64_t n_blocks = header_number(first_in);
  if (n_blocks > where.left() / width)
    where.fail(fmt::format("an array claims {} blocks, more than fit the file", n_blocks));
  if (n_blocks == 0) return {};

  const std::string header = take(where, (3 + n_blocks) * width, is_base64);
  Cursor in(header, where.file());
  header_number(in);
  const std::uint64_t block = header_number(in);
  const std::uint64_t last = header_number(in);
  std::vector<std::uint64_t> packed(n_blocks);
  std::uint64_t n_packed = 0;
  for (std::uint64_t& n : packed) {
    n = header_number(in);
    if (n > where.left() || n_packed + n > where.left())
      where.fail("a packed block reaches beyond the end of the file");
    n_packed += n;
  }
  const std::string data = take(where, n_packed, is_base64);
  std::string out;
  std::size_t at = 0;
  for (std::size_t b = 0; b < packed.size(); ++b) {
    const std::uint64_t size = b + 1 == packed.size() && last > 0 ? last : block;
    if (size > kMostInflation * (packed[b] + 1)) where.fail("a packed block claims more bytes than it can hold");
    const std::size_t before = out.size();
    out.resize(before + static_cast<std::size_t>(size));
    uLongf n = size;
    const int result = uncompress(reinterpret_cast<Bytef*>(out.data() + before), &n,
                                  reinterpret_cast<const Bytef*>(data.data() + at), packed[b]);
    if (result != Z_OK || n != size) where.fail("a packed block is damaged");
    at += static_cast<std::size_t>(packed[b]);
  }
  return out;
}

template <class T>
std::vector<T> VtkXmlInput::values(const XmlArray& array) const {
  Cursor where = at(array);
  const ScalarType type = scalar_type(array.tag.attribute("type"));
  if (type == ScalarType::None) {
    where.fail_expected(fmt::format("a number type for array '{}'", quoted(array.name())), array.tag.attribute("type"));
  }
  std::vector<T> out;
  if (array.tag.attribute("format") == "ascii") {
    const std::size_t end = std::min(where.all().find('<', where.offset()), where.all().size());
    Cursor text(where.all().substr(0, end), where.file());
    text.enter_binary();
    text.seek(where.offset());
    for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
      if constexpr (std::is_integral_v<T>) {
        out.push_back(text.to_integer(word, "a value"));
      } else {
        out.push_back(text.to_number(word, "a value"));
      }
    }
    return out;
  }
  const std::string bytes = raw_bytes(array, where);
  const std::size_t width = size_of(type);
  if (bytes.size() % width != 0) where.fail(fmt::format("array '{}' ends within a value", quoted(array.name())));
  out.resize(bytes.size() / width);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = decode_as<T>(type, bytes.data() + i * width, order_);
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
