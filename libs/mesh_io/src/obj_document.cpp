#include "characters.hpp"
#include "file.hpp"
#include "obj_reader.hpp"
#include "output.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/obj_document.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::mesh {
namespace {

using Range = ObjStatements::Range;

// Words of a statement behind its keyword, across joined lines.
std::vector<std::string_view> words_of(std::string_view statement) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < statement.size();) {
    const auto separates = [&](std::size_t i) {
      return is_space(statement[i]) ||
             (statement[i] == '\\' && (i + 1 == statement.size() || is_line_end(statement[i + 1])));
    };
    if (statement[at] == '#') {  // a comment between joined lines
      while (at < statement.size() && !is_line_end(statement[at])) ++at;
      continue;
    }
    if (separates(at)) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < statement.size() && !separates(end) && statement[end] != '#') ++end;
    words.push_back(statement.substr(at, end - at));
    at = end;
  }
  if (!words.empty()) words.erase(words.begin());
  return words;
}

std::string_view vertex_of(std::string_view corner) {
  return corner.substr(0, corner.find('/'));
}

std::string_view normal_of(std::string_view corner) {
  const std::size_t first = corner.find('/');
  const std::size_t second = first == std::string_view::npos ? first : corner.find('/', first + 1);
  return second == std::string_view::npos ? std::string_view() : corner.substr(second + 1);
}

void append_corner(std::string& text, std::string_view corner, int uv) {
  text.append(" ").append(vertex_of(corner)).append("/");
  append(text, uv + 1);
  if (const std::string_view normal = normal_of(corner); !normal.empty()) text.append("/").append(normal);
}

// As the file has them.
std::string_view line_end_of(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos) return "\n";
  return text.substr(end, text.substr(end, 2) == "\r\n" ? 2 : 1);
}

struct Edit {
  Range range;
  std::string text;
};

}  // namespace

struct ObjDocument::Contents {
  std::string text;
  SurfaceMesh mesh;
  ObjStatements statements;
};

namespace {

class Writer {
 public:
  Writer(std::string_view text, const ObjStatements& statements, const Points2& uv, const Triangles& corners)
      : text_(text), statements_(statements), uv_(uv), corners_(corners), line_end_(line_end_of(text)) {}

  ObjText write() {
    for (const Range& range : statements_.texture) edits_.push_back({whole_line(range), {}});
    for (const Range& range : statements_.left_out) edits_.push_back({whole_line(range), {}});
    result_.removed_faces = static_cast<int>(statements_.left_out.size());
    for (const Range& range : statements_.lines) line(range);
    for (std::size_t f = 0; f < statements_.faces.size(); ++f) face(f);
    add_coordinates();
    result_.names_materials = statements_.materials;
    carry_out();
    return std::move(result_);
  }

 private:
  // With the end of the line, and blanks in front; what stands on the line besides (a comment) stays.
  Range whole_line(Range range) const {
    std::size_t end = range.end;
    while (end < text_.size() && is_space(text_[end]) && !is_line_end(text_[end])) ++end;
    if (end < text_.size() && !is_line_end(text_[end])) return range;
    range.end = std::min(text_.size(), end + (text_.substr(end, 2) == "\r\n" ? 2 : 1));
    while (range.begin > 0 && is_space(text_[range.begin - 1]) && !is_line_end(text_[range.begin - 1]))
      --range.begin;
    return range;
  }

  void line(const Range& range) {
    const std::string_view statement = text_.substr(range.begin, range.end - range.begin);
    if (statement.find('/') == std::string_view::npos) return;
    std::string text = "l";
    for (const std::string_view word : words_of(statement)) {
      if (word.find_first_not_of("-0123456789/") != std::string_view::npos) return;  // nobody's line
      text.append(" ").append(vertex_of(word));
    }
    ++result_.lines_without_uv;
    edits_.push_back({range, text});
  }

  void face(std::size_t f) {
    const Range& range = statements_.faces[f];
    const std::vector<std::string_view> words = words_of(text_.substr(range.begin, range.end - range.begin));
    const std::size_t first = next_triangle_;
    const auto& face_of = statements_.corners.face;
    while (next_triangle_ < face_of.size() && face_of[next_triangle_] == static_cast<int>(f))
      ++next_triangle_;
    std::string text = polygon(words, first);
    if (text.empty()) {
      text = triangles(words, first);
      (text.empty() ? result_.removed_faces : result_.divided_faces) += 1;
    }
    edits_.push_back({text.empty() ? whole_line(range) : range, text});
  }

  int uv_at(std::size_t triangle, std::size_t c) const {
    return corners_(static_cast<Eigen::Index>(triangle), static_cast<Eigen::Index>(c));
  }
  std::size_t place_of(std::size_t triangle, std::size_t c) const {
    return static_cast<std::size_t>(statements_.corners.corner[3 * triangle + c]);
  }

  // The face with its own corners; empty where its triangles do not agree, or some are left out.
  std::string polygon(const std::vector<std::string_view>& words, std::size_t first) const {
    if (first == next_triangle_) return {};
    std::vector<int> uv(words.size(), -1);
    for (std::size_t t = first; t < next_triangle_; ++t)
      for (std::size_t c = 0; c < 3; ++c) {
        const int given = uv_at(t, c);
        int& own = uv[place_of(t, c)];
        if (given < 0 || (own >= 0 && uv_.row(own) != uv_.row(given))) return {};
        if (own < 0) own = given;
      }
    std::string text = "f";
    for (std::size_t c = 0; c < words.size(); ++c)
      if (uv[c] >= 0) append_corner(text, words[c], uv[c]);  // others repeat the corner before
    return text;
  }

  std::string triangles(const std::vector<std::string_view>& words, std::size_t first) const {
    std::string text;
    for (std::size_t t = first; t < next_triangle_; ++t) {
      if (uv_at(t, 0) < 0) continue;
      if (!text.empty()) text.append(line_end_);
      text.append("f");
      for (std::size_t c = 0; c < 3; ++c) append_corner(text, words[place_of(t, c)], uv_at(t, c));
    }
    return text;
  }

  // In front of the first face.
  void add_coordinates() {
    std::string text;
    for (Eigen::Index i = 0; i < uv_.rows(); ++i) {
      text += "vt";
      append_row(text, uv_, i);
      text += line_end_;
    }
    std::size_t begin = statements_.faces.front().begin;
    while (begin > 0 && !is_line_end(text_[begin - 1])) --begin;
    edits_.push_back({{begin, begin}, text});
  }

  void carry_out() {
    std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) {
      return std::pair(a.range.begin, a.range.end) < std::pair(b.range.begin, b.range.end);
    });
    std::size_t at = byte_order_mark(text_);
    for (const Edit& edit : edits_) {
      const std::size_t begin = std::max(at, edit.range.begin);
      result_.text.append(text_.substr(at, begin - at)).append(edit.text);
      at = std::max(begin, edit.range.end);
    }
    result_.text.append(text_.substr(at));
  }

  std::string_view text_;
  const ObjStatements& statements_;
  const Points2& uv_;
  const Triangles& corners_;
  std::string_view line_end_;
  std::size_t next_triangle_ = 0;
  std::vector<Edit> edits_;
  ObjText result_;
};

void require_uv(const SurfaceMesh& mesh, const Points2& uv, const Triangles& corners) {
  if (corners.rows() != mesh.triangles.rows())
    throw Error("texture coordinates for " + std::to_string(corners.rows()) + " triangles, where there are " +
                std::to_string(mesh.triangles.rows()));
  for (Eigen::Index t = 0; t < corners.rows(); ++t)
    if (corners.row(t).maxCoeff() >= uv.rows() ||
        (corners.row(t).minCoeff() < 0 && corners.row(t).maxCoeff() >= 0))
      throw Error("triangle " + std::to_string(t) + ": index of a texture coordinate out of range");
  for (Eigen::Index i = 0; i < uv.rows(); ++i)
    if (!uv.row(i).allFinite()) throw Error("texture coordinate " + std::to_string(i) + " is not finite");
}

}  // namespace

ObjDocument::ObjDocument(std::unique_ptr<Contents> contents) : contents_(std::move(contents)) {}
ObjDocument::ObjDocument(ObjDocument&&) noexcept = default;
ObjDocument& ObjDocument::operator=(ObjDocument&&) noexcept = default;
ObjDocument::~ObjDocument() = default;

ObjDocument ObjDocument::parse(std::string text, const std::string& name, const ReadOptions& options) {
  auto contents = std::make_unique<Contents>();
  contents->text = std::move(text);
  contents->mesh = parse_obj(contents->text, name, options, &contents->statements);
  return ObjDocument(std::move(contents));
}

ObjDocument ObjDocument::read(const std::string& path, const ReadOptions& options) {
  return parse(read_file(path), path, options);
}

const SurfaceMesh& ObjDocument::mesh() const {
  return contents_->mesh;
}

ObjText ObjDocument::with_uv(const Points2& uv, const Triangles& corners) const {
  require_uv(contents_->mesh, uv, corners);
  return Writer(contents_->text, contents_->statements, uv, corners).write();
}

}  // namespace isostretch::mesh
