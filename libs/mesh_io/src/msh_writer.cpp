#include "file.hpp"
#include "msh_elements.hpp"
#include "output.hpp"
#include "writable.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <cstdint>

namespace isostretch::mesh {
namespace {

// One entity, with tag 1, that has all nodes and elements.
template <class Elements>
class MshWriter {
 public:
  MshWriter(const Points3& vertices, const Elements& elements, const WriteOptions& options)
      : vertices_(vertices),
        elements_(elements),
        version_(options.msh_version),
        binary_(options.encoding == Encoding::binary) {}

  std::string write() {
    format();
    if (version_ == MshVersion::v2_2) {
      nodes_in_one();
      elements_in_one();
    } else {
      entities();
      nodes_in_block();
      elements_in_block();
    }
    return std::move(out_);
  }

 private:
  static constexpr int dimension = Elements::ColsAtCompileTime - 1;
  static constexpr int type = dimension == 2 ? msh_triangle : msh_tet;

  void format() {
    const char* version = version_ == MshVersion::v2_2 ? "2.2" : version_ == MshVersion::v4_0 ? "4.0" : "4.1";
    out_ += std::string("$MeshFormat\n") + version + (binary_ ? " 1 8\n" : " 0 8\n");
    if (binary_) numbers<std::int32_t>({1});
    if (binary_) out_ += '\n';
    out_ += "$EndMeshFormat\n";
  }

  // On a line of their own in text.
  template <class Number>
  void numbers(std::initializer_list<Number> values) {
    bool first = true;
    for (const Number value : values) {
      if (binary_) {
        append_bytes(out_, value);
      } else {
        if (!first) out_ += ' ';
        append(out_, value);
      }
      first = false;
    }
    if (!binary_) out_ += '\n';
  }

  void integers(std::initializer_list<std::int32_t> values) { numbers(values); }
  void sizes(std::initializer_list<std::uint64_t> values) { numbers(values); }

  void end(const char* keyword) {
    if (binary_) out_ += '\n';
    out_ += keyword;
    out_ += '\n';
  }

  static std::uint64_t size(Eigen::Index rows) { return static_cast<std::uint64_t>(rows); }

  // The entity has no boundary and no physical groups.
  void entities() {
    out_ += "$Entities\n";
    sizes({0, 0, dimension == 2 ? 1u : 0u, dimension == 3 ? 1u : 0u});
    const Eigen::RowVector3d low = vertices_.colwise().minCoeff(), high = vertices_.colwise().maxCoeff();
    if (binary_) {
      integers({1});
      numbers({low.x(), low.y(), low.z(), high.x(), high.y(), high.z()});
      sizes({0, 0});
    } else {
      out_ += '1';
      append_row(out_, low, 0);
      append_row(out_, high, 0);
      out_ += " 0 0\n";
    }
    end("$EndEntities");
  }

  // Of the entity in front of a block.
  void entity() {
    if (version_ == MshVersion::v4_1)
      block_start(dimension, 1);
    else
      block_start(1, dimension);
  }
  void block_start(std::int32_t first, std::int32_t second) {
    if (binary_)
      integers({first, second});
    else
      out_ += std::to_string(first) + ' ' + std::to_string(second) + ' ';
  }
  // What ends it: one more number and the number of items.
  void block_end(std::int32_t number, Eigen::Index count) {
    if (binary_) {
      integers({number});
      sizes({size(count)});
    } else {
      out_ += std::to_string(number) + ' ' + std::to_string(count) + '\n';
    }
  }

  void totals(Eigen::Index count) {
    if (version_ == MshVersion::v4_1)
      sizes({1, size(count), 1, size(count)});
    else
      sizes({1, size(count)});
  }

  void tag(Eigen::Index index) {
    if (!binary_)
      append(out_, index + 1);
    else if (version_ == MshVersion::v4_1)
      append_bytes(out_, size(index + 1));
    else
      append_bytes(out_, static_cast<std::int32_t>(index + 1));
  }

  void point(Eigen::Index v) {
    if (binary_)
      append_row_bytes(out_, vertices_, v);
    else
      append_row(out_, vertices_, v);
  }

  void end_of_line() {
    if (!binary_) out_ += '\n';
  }

  void tagged_points() {
    for (Eigen::Index v = 0; v < vertices_.rows(); ++v) {
      tag(v);
      point(v);
      end_of_line();
    }
  }

  void nodes_in_one() {
    out_ += "$Nodes\n" + std::to_string(vertices_.rows()) + '\n';
    tagged_points();
    end("$EndNodes");
  }

  void nodes_in_block() {
    out_ += "$Nodes\n";
    totals(vertices_.rows());
    entity();
    block_end(0, vertices_.rows());
    if (version_ == MshVersion::v4_0)
      tagged_points();
    else
      tags_and_points();
    end("$EndNodes");
  }

  void tags_and_points() {
    for (Eigen::Index v = 0; v < vertices_.rows(); ++v) {
      tag(v);
      end_of_line();
    }
    for (Eigen::Index v = 0; v < vertices_.rows(); ++v) {
      point(v);
      end_of_line();
    }
  }

  void corners(Eigen::Index e) {
    for (Eigen::Index c = 0; c < elements_.cols(); ++c) {
      if (!binary_) out_ += ' ';
      tag(elements_(e, c));
    }
    end_of_line();
  }

  // In binary one run after a header, in text a line for each; physical group 0 and entity 1 are its tags.
  void elements_in_one() {
    out_ += "$Elements\n" + std::to_string(elements_.rows()) + '\n';
    if (binary_) integers({type, static_cast<std::int32_t>(elements_.rows()), 2});
    for (Eigen::Index e = 0; e < elements_.rows(); ++e) {
      tag(e);
      if (binary_)
        integers({0, 1});
      else
        out_ += ' ' + std::to_string(type) + " 2 0 1";
      corners(e);
    }
    end("$EndElements");
  }

  void elements_in_block() {
    out_ += "$Elements\n";
    totals(elements_.rows());
    entity();
    block_end(type, elements_.rows());
    for (Eigen::Index e = 0; e < elements_.rows(); ++e) {
      tag(e);
      corners(e);
    }
    end("$EndElements");
  }

  const Points3& vertices_;
  const Elements& elements_;
  MshVersion version_;
  bool binary_;
  std::string out_;
};

}  // namespace

std::string format_msh(const SurfaceMesh& mesh, const WriteOptions& options) {
  require_writable(mesh);
  return MshWriter(mesh.vertices, mesh.triangles, options).write();
}

std::string format_msh(const TetMesh& mesh, const WriteOptions& options) {
  require_writable(mesh);
  return MshWriter(mesh.vertices, mesh.tets, options).write();
}

void write_msh(const std::string& path, const SurfaceMesh& mesh, const WriteOptions& options) {
  write_file(path, format_msh(mesh, options));
}

void write_msh(const std::string& path, const TetMesh& mesh, const WriteOptions& options) {
  write_file(path, format_msh(mesh, options));
}

}  // namespace isostretch::mesh
