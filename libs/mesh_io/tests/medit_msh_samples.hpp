#pragma once

// The sample mesh in MEDIT, and in every version and coding of MSH.
#include "contents.hpp"
#include "sample_mesh.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <utility>

namespace isostretch::mesh::test {

inline Sample medit_sample(bool tets, const Variation& variation = {}) {
  const Model model(tets, variation);
  Contents file;
  file.text("MeshVersionFormatted 2\n# comment\nDimension\n3\nVertices\n" + count_text(model.point_count) +
            "\n");
  file.points(model, false, "", " 7");
  file.text("Corners\n2\n1 2\n");
  file.text((tets ? "Tetrahedra\n" : "Triangles\n") + count_text(model.element_count) + "\n");
  file.elements(model, "", 1, " 5").text("End\n");
  return {tets ? "s_tets.mesh" : "s_surface.mesh", file.str(), tets};
}

// Tags begin with 10; a point and a line that are to be skipped come first.
inline Sample msh_sample(const std::string& version, const std::string& coding, bool tets,
                         const Variation& variation = {}) {
  const Model model(tets, variation);
  const bool binary = coding != "text", v2 = version == "2.2", v4 = version == "4";
  const auto points = static_cast<std::int64_t>(model.points.rows());
  const int dimension = tets ? 3 : 2, type = tets ? 4 : 2;
  Contents file(coding == "big" ? std::endian::big : std::endian::little);
  const auto i32 = [&](std::int64_t value) {
    if (binary)
      file.bytes(static_cast<std::int32_t>(value));
    else
      file.text(std::to_string(value) + " ");
  };
  const auto u64 = [&](std::int64_t value) {
    if (binary)
      file.bytes(value);
    else
      file.text(std::to_string(value) + " ");
  };
  const auto tag = [&](std::int64_t value) { version == "4.1" ? u64(value) : i32(value); };
  const auto end_line = [&] {
    if (!binary) file.text("\n");
  };
  const auto point = [&](Eigen::Index v) {
    for (int c = 0; c < 3; ++c)
      if (binary)
        file.bytes(model.points(v, c));
      else
        file.number(model.points(v, c)).text(" ");
    end_line();
  };
  const auto entity = [&](int dim, int number) {
    i32(v4 ? number : dim);
    i32(v4 ? dim : number);
  };
  const auto totals = [&](std::int64_t blocks, std::int64_t count) {
    u64(blocks);
    u64(count);
    if (version == "4.1") {
      u64(10);
      u64(10 + count);
    }
    end_line();
  };
  file.text("$MeshFormat\n" + version + (binary ? " 1 8\n" : " 0 8\n"));
  if (binary) file.bytes(std::int32_t{1}).text("\n");
  file.text("$EndMeshFormat\n$Comments\nanything $ at all\n$EndComments\n$Nodes\n");
  if (v2) {
    file.text(count_text(model.point_count) + "\n");
  } else {
    totals(1, model.point_count);
    entity(dimension, 1);
    i32(0);
    u64(model.point_count);
    end_line();
  }
  for (std::int64_t v = 0; version == "4.1" && v < points; ++v) {
    u64(10 + v);
    end_line();
  }
  for (Eigen::Index v = 0; v < points; ++v) {
    if (version != "4.1") tag(10 + v);
    point(v);
  }
  file.text("$EndNodes\n$Elements\n");
  const std::int64_t total = model.element_count + 2;
  if (v2) {
    file.text(count_text(total) + "\n");
    for (const auto& [kind, corners] : {std::pair{15, 1}, std::pair{1, 2}}) {
      if (binary) {
        i32(kind);
        i32(1);
        i32(2);
      }
      i32(kind);
      if (!binary) {
        i32(kind);
        i32(2);
      }
      i32(0);
      i32(1);
      for (int c = 0; c < corners; ++c) i32(10 + c);
      end_line();
    }
    if (binary && !model.elements.empty()) {
      i32(type);
      i32(model.element_count);
      i32(2);
    }
  } else {
    totals(3, total);
    for (const auto& [kind, corners] : {std::pair{15, 1}, std::pair{1, 2}}) {
      entity(corners - 1, 1);
      i32(kind);
      u64(1);
      end_line();
      tag(kind);
      for (int c = 0; c < corners; ++c) tag(10 + c);
      end_line();
    }
    entity(dimension, 1);
    i32(type);
    u64(model.element_count);
    end_line();
  }
  std::int64_t number = 100;
  for (const auto& element : model.elements) {
    tag(number++);
    if (v2 && !binary) {
      i32(type);
      i32(2);
    }
    if (v2) {
      i32(0);
      i32(1);
    }
    for (const int corner : element) tag(10 + std::int64_t{corner});
    end_line();
  }
  file.text("$EndElements\n");
  return {"s_" + version + "_" + coding + (tets ? "_tets.msh" : "_surface.msh"), file.str(), tets, !binary};
}

}  // namespace isostretch::mesh::test
