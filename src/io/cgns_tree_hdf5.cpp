#include "io/cgns_tree_hdf5.h"

#include <fmt/format.h>

#include "nearwall/core/errors.h"

namespace nearwall::io {
namespace {

constexpr std::size_t kFew = 64;

}  // namespace

std::optional<CgnsNode> CgnsNode::named(const std::string& name) const {
  std::optional<Hdf5Group> group = group_.group(name);
  if (!group) return std::nullopt;
  if (group->text("type") == "LK") {
    throw InputError(fmt::format("{}: {} is a link to another node, which is not followed: put the data into the file",
                                 file_->name(), group->name()));
  }
  return CgnsNode(*file_, std::move(*group), name);
}

std::vector<CgnsNode> CgnsNode::children(const std::string& label) const {
  std::vector<CgnsNode> found;
  for (const std::string& name : group_.members()) {
    if (name.starts_with(' ')) continue;  // data of this node
    if (!group_.is_group(name)) continue;
    std::optional<CgnsNode> node = named(name);
    if (node && node->group_.text("label") == label) found.push_back(std::move(*node));
  }
  return found;
}

std::optional<CgnsNode> CgnsNode::child(const std::string& label) const {
  std::vector<CgnsNode> found = children(label);
  if (found.empty()) return std::nullopt;
  return std::move(found.front());
}

std::vector<std::int64_t> CgnsNode::integers(std::size_t least) const {
  const Hdf5Array array = data();
  if (array.size() < least || array.size() > kFew) {
    file_->fail(fmt::format("{} has {} values, expected {}", path(), array.size(), least));
  }
  return array.all<std::int64_t>();
}

std::vector<std::int64_t> CgnsNode::named_integers(const std::string& name, std::size_t least) const {
  const std::optional<CgnsNode> node = named(name);
  if (!node) file_->fail(fmt::format("{}/{} is missing", path(), name));
  return node->integers(least);
}

std::string CgnsNode::named_characters(const std::string& name) const {
  const std::optional<CgnsNode> node = named(name);
  return node ? node->characters() : std::string();
}

}  // namespace nearwall::io
