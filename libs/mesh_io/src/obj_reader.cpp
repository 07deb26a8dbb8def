#include "obj_reader.hpp"

#include "file.hpp"
#include "input_cursor.hpp"
#include "number.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <charconv>

namespace isostretch::mesh {
namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name, const ReadOptions& options,
            ObjStatements* statements)
      : cursor_(text, name), options_(options), faces_(options), statements_(statements) {
    cursor_.set_comments(true);
    cursor_.set_by_line(true);
    cursor_.set_continued(true);
  }

  SurfaceMesh read() {
    for (cursor_.next_line(); cursor_.left() > 0; cursor_.next_line()) statement();
    return finish();
  }

 private:
  // The rest of the line of a comment or a name belongs to it, a backslash at its end included; only
  // statements of numbers go on in the next line.
  void statement() {
    const std::size_t begin = cursor_.position();
    const std::string_view keyword = cursor_.word();
    if (keyword == "v") {
      for (const char* what : axis_labels) vertices_.push_back(cursor_.text_coordinate(what));
      cursor_.drop_words();  // a weight, a colour
    } else if (keyword == "vt") {
      record(begin, texture_coordinate(), &ObjStatements::texture);
    } else if (keyword == "f") {
      face(begin);
    } else if (keyword == "mtllib" && statements_) {
      statements_->materials = true;
    } else if (keyword == "vn" || keyword == "vp" || keyword == "p") {
      cursor_.drop_words();
    } else if (keyword == "l") {
      record(begin, cursor_.drop_words(), &ObjStatements::lines);
    }
  }

  void record(std::size_t begin, std::size_t end, std::vector<ObjStatements::Range> ObjStatements::*list) {
    if (statements_) (statements_->*list).push_back({begin, end});
  }

  // Says where it ends.
  std::size_t texture_coordinate() {
    if (!options_.read_uv) return cursor_.drop_words();
    uv_.push_back(cursor_.text_coordinate("u coordinate"));
    const std::size_t end = cursor_.position();
    const bool one = cursor_.empty();
    uv_.push_back(one ? 0.0 : cursor_.text_coordinate("v coordinate"));
    return one ? end : cursor_.drop_words();
  }

  void face(std::size_t begin) {
    const Place place = cursor_.place();
    polygon_.clear();
    uv_polygon_.clear();
    std::size_t end = cursor_.position();
    while (!cursor_.empty()) {
      corner(cursor_.word());
      end = cursor_.position();
    }
    if (!uv_polygon_.empty() && uv_polygon_.size() != polygon_.size())
      place.fail("only some corners of the face have a texture coordinate");
    const std::size_t before = faces_.count();
    faces_.add(polygon_, uv_polygon_, place);
    if (!statements_) return;
    auto& list = faces_.count() > before ? statements_->faces : statements_->left_out;
    list.push_back({begin, end});
  }

  // v, v/t, v/t/n or v//n.
  void corner(std::string_view word) {
    polygon_.push_back(index(word, "vertex", vertices_.size() / 3, highest_vertex_));
    const bool more = take_slash(word), without_uv = more && take_slash(word);
    if (more && !without_uv) texture_index(word);
    if (without_uv || (more && take_slash(word))) number(word, "normal index");
    if (!word.empty()) cursor_.fail("face corner is not of the form v, v/t, v/t/n or v//n");
  }

  void texture_index(std::string_view& word) {
    if (options_.read_uv)
      uv_polygon_.push_back(index(word, "texture", uv_.size() / 2, highest_uv_));
    else
      number(word, "texture index");
  }

  static bool take_slash(std::string_view& word) {
    const bool found = !word.empty() && word.front() == '/';
    if (found) word.remove_prefix(1);
    return found;
  }

  // Takes the number in front of the word.
  int number(std::string_view& word, const std::string& what) const {
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::result_out_of_range) cursor_.fail(what + " " + quoted(word) + " is too large");
    if (error != std::errc()) cursor_.fail(what + " expected, not " + quoted(word));
    word.remove_prefix(static_cast<std::size_t>(end - word.data()));
    return value;
  }

  // A face may name vertices that only follow: the highest index is remembered and compared at the end.
  struct Highest {
    std::int64_t index = -1;
    std::size_t position = 0;
  };

  int index(std::string_view& word, const char* what, std::size_t count, Highest& highest) const {
    const std::string label = std::string(what) + " index";
    const std::int64_t given = number(word, label);
    if (given == 0) cursor_.fail(label + " 0: OBJ counts from 1");
    const std::int64_t found = given > 0 ? given - 1 : static_cast<std::int64_t>(count) + given;
    if (found < 0)
      cursor_.fail(label + " " + std::to_string(given) + " reaches before the first of " +
                   std::to_string(count));
    if (found > highest.index) highest = {found, cursor_.place().position};
    return static_cast<int>(found);
  }

  void require_in_range(const char* what, std::size_t count, const Highest& highest) const {
    if (highest.index < static_cast<std::int64_t>(count)) return;
    cursor_.place(highest.position)
        .fail(out_of_range((std::string(what) + " index").c_str(), highest.index + 1, count));
  }

  SurfaceMesh finish() const {
    const Place end = cursor_.place(cursor_.contents().size());
    if (vertices_.empty() && faces_.empty()) end.fail("no vertices and no faces");
    if (faces_.empty()) end.fail("no faces");
    require_in_range("vertex", vertices_.size() / 3, highest_vertex_);
    require_in_range("texture", uv_.size() / 2, highest_uv_);
    return faces_.surface(vertices_, uv_, end, statements_ ? &statements_->corners : nullptr);
  }

  InputCursor cursor_;
  const ReadOptions& options_;
  FaceList faces_;
  ObjStatements* statements_;
  std::vector<double> vertices_, uv_;
  std::vector<int> polygon_, uv_polygon_;  // of the face being read
  Highest highest_vertex_, highest_uv_;
};

}  // namespace

SurfaceMesh parse_obj(std::string_view text, const std::string& name, const ReadOptions& options,
                      ObjStatements* statements) {
  return ObjReader(text, name, options, statements).read();
}

SurfaceMesh parse_obj(std::string_view text, const std::string& name, const ReadOptions& options) {
  return parse_obj(text, name, options, nullptr);
}

SurfaceMesh read_obj(const std::string& path, const ReadOptions& options) {
  return parse_obj(read_file(path), path, options);
}

}  // namespace isostretch::mesh
