#include "file.hpp"
#include "output.hpp"
#include "writable.hpp"

#include <isostretch/core/error.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace isostretch::mesh {
namespace {

// Vertices as glTF has them: one for every pair of a vertex and a texture coordinate that a triangle uses.
struct SplitVertices {
  std::vector<int> vertex;
  std::vector<int> uv;
  std::vector<std::uint32_t> corners;  // three a triangle
};

SplitVertices split(const SurfaceMesh& mesh) {
  SplitVertices split;
  // Copies of a vertex are chained: the newest, and the one before each.
  std::vector<int> newest(static_cast<std::size_t>(mesh.vertices.rows()), -1), older;
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i) {
    const int vertex = mesh.triangles.data()[i], uv = mesh.has_uv() ? mesh.uv_triangles.data()[i] : -1;
    int& head = newest[static_cast<std::size_t>(vertex)];
    int copy = head;
    while (copy >= 0 && split.uv[static_cast<std::size_t>(copy)] != uv)
      copy = older[static_cast<std::size_t>(copy)];
    if (copy < 0) {
      copy = static_cast<int>(split.vertex.size());
      split.vertex.push_back(vertex);
      split.uv.push_back(uv);
      older.push_back(head);
      head = copy;
    }
    split.corners.push_back(static_cast<std::uint32_t>(copy));
  }
  return split;
}

// Unit vectors. Scaled edges first: areas of huge or tiny triangles leave the range of double.
Points3 vertex_normals(const SurfaceMesh& mesh) {
  const double size = mesh.vertices.cwiseAbs().maxCoeff();
  const double scale = size > 0 ? 1 / std::max(size, std::numeric_limits<double>::min()) : 1;
  Points3 normals = Points3::Zero(mesh.vertices.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int c) -> Eigen::RowVector3d {
      return mesh.vertices.row(mesh.triangles(t, c)) * scale;
    };
    const Eigen::RowVector3d twice_area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (int c = 0; c < 3; ++c) normals.row(mesh.triangles(t, c)) += twice_area;
  }
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    const double length = normals.row(v).norm();
    if (length > 0 && std::isfinite(1 / length))
      normals.row(v) /= length;
    else
      normals.row(v) = Eigen::RowVector3d(0, 0, 1);
  }
  return normals;
}

float to_float(double value, const char* what, int index) {
  if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max()))
    throw Error(std::string(what) + " " + std::to_string(index) +
                " has a coordinate that is too large for glTF");
  return static_cast<float>(value);
}

// The binary chunk with its views and accessors, in the words of the JSON chunk.
class GlbWriter {
 public:
  GlbWriter(const SurfaceMesh& mesh, const GlbOptions& options, const std::vector<GlbFrame>& frames)
      : mesh_(mesh), options_(options), frames_(frames), split_(split(mesh)) {}

  std::string write() {
    const int indices = index_accessor();
    std::string attributes = "\"POSITION\":" + std::to_string(position_accessor());
    if (options_.normals) attributes += ",\"NORMAL\":" + std::to_string(normal_accessor());
    if (mesh_.has_uv()) attributes += ",\"TEXCOORD_0\":" + std::to_string(uv_accessor());
    const std::string targets = morph_targets(), animation = this->animation();
    const std::string material = this->material();
    std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"isostretch\"}," +
                       std::string(repeats() ? "\"extensionsUsed\":[\"KHR_texture_transform\"]," : "") +
                       "\"scene\":0,\"scenes\":[{\"nodes\":[0]"
                       "}],"
                       "\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{" +
                       attributes + "},\"indices\":" + std::to_string(indices) + ",\"material\":0" + targets +
                       "}]}]," + material + animation + ",\"accessors\":[" + accessors_ +
                       "],\"bufferViews\":[" + views_ +
                       "],\"buffers\":[{\"byteLength\":" + std::to_string(data_.size()) + "}]}";
    return container(std::move(json));
  }

 private:
  static constexpr int vertex_target = 34962;  // ARRAY_BUFFER
  static constexpr int index_target = 34963;   // ELEMENT_ARRAY_BUFFER
  static constexpr int float_type = 5126;
  static constexpr int uint32_type = 5125;

  // A view from `start` to the end of the data, which a multiple of 4 bytes ends. Returns its number.
  int add_view(std::size_t start, int target) {
    views_ += view_count_ > 0 ? ",{" : "{";
    views_ += "\"buffer\":0,\"byteOffset\":" + std::to_string(start) +
              ",\"byteLength\":" + std::to_string(data_.size() - start);
    if (target != 0) views_ += ",\"target\":" + std::to_string(target);
    views_ += '}';
    while (data_.size() % 4 != 0) data_ += '\0';
    return view_count_++;
  }

  int add_accessor(std::size_t start, int target, int component, std::size_t count, const std::string& rest) {
    const int view = add_view(start, target);
    accessors_ += accessor_count_ > 0 ? ",{" : "{";
    accessors_ += "\"bufferView\":" + std::to_string(view) +
                  ",\"componentType\":" + std::to_string(component) + ",\"count\":" + std::to_string(count) +
                  rest + '}';
    return accessor_count_++;
  }

  int index_accessor() {
    for (const std::uint32_t corner : split_.corners) append_bytes(data_, corner);
    return add_accessor(0, index_target, uint32_type, split_.corners.size(), ",\"type\":\"SCALAR\"");
  }

  int position_accessor() { return vector_accessor(mesh_.vertices, "vertex"); }

  // A row of every vertex of the file, with their bounds.
  int vector_accessor(const Points3& rows, const char* what) {
    const std::size_t start = data_.size();
    float low[3], high[3];
    std::fill_n(low, 3, std::numeric_limits<float>::max());
    std::fill_n(high, 3, std::numeric_limits<float>::lowest());
    for (const int v : split_.vertex)
      for (int c = 0; c < 3; ++c) {
        const float value = to_float(rows(v, c), what, v);
        low[c] = std::min(low[c], value);
        high[c] = std::max(high[c], value);
        append_bytes(data_, value);
      }
    return add_accessor(start, vertex_target, float_type, split_.vertex.size(),
                        ",\"type\":\"VEC3\",\"min\":" + json_of(low) + ",\"max\":" + json_of(high));
  }

  // Of the double with the same value: viewers compare after reading it as such.
  template <std::size_t Count>
  static std::string json_of(const float (&values)[Count]) {
    std::string text = "[";
    for (const float value : values) {
      if (text.size() > 1) text += ',';
      append(text, static_cast<double>(value));
    }
    return text + ']';
  }

  int normal_accessor() {
    const std::size_t start = data_.size();
    const Points3 normals = vertex_normals(mesh_);
    for (const int v : split_.vertex)
      for (int c = 0; c < 3; ++c) append_bytes(data_, static_cast<float>(normals(v, c)));
    return add_accessor(start, vertex_target, float_type, split_.vertex.size(), ",\"type\":\"VEC3\"");
  }

  // glTF's origin is the upper left corner of the image.
  int uv_accessor() {
    const std::size_t start = data_.size();
    for (const int t : split_.uv) {
      append_bytes(data_, to_float(mesh_.uv(t, 0), "uv point", t));
      append_bytes(data_, to_float(1 - mesh_.uv(t, 1), "uv point", t));
    }
    return add_accessor(start, vertex_target, float_type, split_.uv.size(), ",\"type\":\"VEC2\"");
  }

  // What every frame adds to the places of the vertices.
  std::string morph_targets() {
    std::string targets;
    for (const GlbFrame& frame : frames_) {
      targets += targets.empty() ? ",\"targets\":[{" : ",{";
      targets += "\"POSITION\":" + std::to_string(displacement_accessor(frame)) + '}';
    }
    return targets.empty() ? targets : targets + ']';
  }

  int displacement_accessor(const GlbFrame& frame) {
    const Points3 displacement = frame.vertices - mesh_.vertices;
    return vector_accessor(displacement, "displacement of vertex");
  }

  // At its own time a frame has weight 1 and all others have 0.
  std::string animation() {
    if (frames_.empty()) return {};
    const std::size_t times = data_.size();
    for (const GlbFrame& frame : frames_) append_bytes(data_, static_cast<float>(frame.seconds));
    const float first[] = {static_cast<float>(frames_.front().seconds)},
                last[] = {static_cast<float>(frames_.back().seconds)};
    const int input =
        add_accessor(times, 0, float_type, frames_.size(),
                     ",\"type\":\"SCALAR\",\"min\":" + json_of(first) + ",\"max\":" + json_of(last));
    const std::size_t weights = data_.size();
    for (std::size_t frame = 0; frame < frames_.size(); ++frame)
      for (std::size_t target = 0; target < frames_.size(); ++target)
        append_bytes(data_, frame == target ? 1.0F : 0.0F);
    const int output =
        add_accessor(weights, 0, float_type, frames_.size() * frames_.size(), ",\"type\":\"SCALAR\"");
    return ",\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"weights\"}}],"
           "\"samplers\":[{\"input\":" +
           std::to_string(input) + ",\"interpolation\":\"LINEAR\",\"output\":" + std::to_string(output) +
           "}]}]";
  }

  // Linear filtering, between the levels of a mipmap where the picture is made smaller.
  std::string material() {
    const std::string start = "\"materials\":[{\"pbrMetallicRoughness\":{";
    const std::string end = ",\"metallicFactor\":0,\"roughnessFactor\":1},\"doubleSided\":true}]";
    if (options_.base_color_png.empty()) return start + "\"baseColorFactor\":[0.8,0.8,0.8,1]" + end;
    const std::size_t picture = data_.size();
    data_ += options_.base_color_png;
    return start + "\"baseColorTexture\":{\"index\":0" + transform() + "}" + end +
           ",\"textures\":[{\"sampler\":0,\"source\":0}],\"samplers\":[{\"magFilter\":9729,\"minFilter\":"
           "9987}],"
           "\"images\":[{\"mimeType\":\"image/png\",\"bufferView\":" +
           std::to_string(add_view(picture, 0)) + "}]";
  }

  bool repeats() const { return !options_.base_color_png.empty() && options_.repeats != 1; }

  // Of coordinates that run down from the upper left corner: the lower one stays where it is.
  std::string transform() const {
    if (!repeats()) return {};
    std::string text = ",\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0,";
    append(text, 1 - options_.repeats);
    text += "],\"scale\":[";
    append(text, options_.repeats);
    text += ',';
    append(text, options_.repeats);
    return text + "]}}";
  }

  // Header, JSON chunk filled up with blanks, binary chunk.
  std::string container(std::string json) const {
    while (json.size() % 4 != 0) json += ' ';
    const std::size_t length = 12 + 8 + json.size() + 8 + data_.size();
    if (length > std::numeric_limits<std::uint32_t>::max())
      throw Error("the mesh is too large for glTF: " + std::to_string(length) + " bytes");
    std::string out = "glTF";
    append_bytes(out, std::uint32_t{2});
    append_bytes(out, static_cast<std::uint32_t>(length));
    append_chunk(out, "JSON", json);
    append_chunk(out, std::string_view("BIN\0", 4), data_);
    return out;
  }

  static void append_chunk(std::string& out, std::string_view type, std::string_view chunk) {
    append_bytes(out, static_cast<std::uint32_t>(chunk.size()));
    out += type;
    out += chunk;
  }

  const SurfaceMesh& mesh_;
  const GlbOptions& options_;
  const std::vector<GlbFrame>& frames_;
  SplitVertices split_;
  std::string data_, views_, accessors_;
  int view_count_ = 0;
  int accessor_count_ = 0;
};

void require_png(const SurfaceMesh& mesh, const std::string& png) {
  if (png.empty()) return;
  if (png.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0) throw Error("the base colour is not a PNG file");
  if (!mesh.has_uv()) throw Error("a base colour texture needs texture coordinates, the mesh has none");
}

void require_frames(const SurfaceMesh& mesh, const std::vector<GlbFrame>& frames) {
  if (frames.empty()) throw Error("an animation without frames");
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string name = "frame " + std::to_string(i) + " of the animation";
    if (frames[i].vertices.rows() != mesh.vertices.rows())
      throw Error(name + " has " + std::to_string(frames[i].vertices.rows()) + " vertices, the mesh has " +
                  std::to_string(mesh.vertices.rows()));
    if (!frames[i].vertices.allFinite()) throw Error(name + " has a coordinate that is not finite");
    if (!std::isfinite(frames[i].seconds) || (i > 0 && !(frames[i].seconds > frames[i - 1].seconds)))
      throw Error(name + " is not later than the one before");
  }
}

}  // namespace

std::string format_glb_animation(const SurfaceMesh& mesh, const std::vector<GlbFrame>& frames) {
  require_writable(mesh);
  require_frames(mesh, frames);
  const GlbOptions options{.normals = false};
  return GlbWriter(mesh, options, frames).write();
}

std::string format_glb(const SurfaceMesh& mesh, const GlbOptions& options) {
  require_writable(mesh);
  require_png(mesh, options.base_color_png);
  if (!(options.repeats > 0) || !std::isfinite(options.repeats))
    throw Error("glTF: the picture must be repeated a positive number of times");
  const std::vector<GlbFrame> still;
  return GlbWriter(mesh, options, still).write();
}

void write_glb(const std::string& path, const SurfaceMesh& mesh, const GlbOptions& options) {
  write_file(path, format_glb(mesh, options));
}

}  // namespace isostretch::mesh
