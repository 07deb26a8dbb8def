#pragma once

// The sample mesh in formats that hold surfaces only: OBJ, OFF, PLY and STL.
#include "contents.hpp"
#include "sample_mesh.hpp"

#include <bit>
#include <cstdint>
#include <string>

namespace isostretch::mesh::test {

inline Sample obj_sample(const Variation& variation = {}) {
  const Model model(false, variation);
  return {"s.obj", Contents().points(model, false, "v ").elements(model, "f ", 1).str(), false, true, true,
          false};
}

inline Sample off_sample(const Variation& variation = {}) {
  const Model model(false, variation);
  Contents file;
  file.text("OFF\n" + count_text(model.point_count) + " " + count_text(model.element_count) + " 0\n");
  return {"s.off", file.points(model, false).elements(model, "3 ").str()};
}

// In text, or doubles and 32-bit integers.
inline Sample ply_sample(const std::string& format, const Variation& variation = {}) {
  const Model model(false, variation);
  const bool binary = format != "ascii";
  Contents file(format == "binary_big_endian" ? std::endian::big : std::endian::little);
  file.text("ply\nformat " + format + " 1.0\nelement vertex " + count_text(model.point_count) +
            "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
            count_text(model.element_count) + "\nproperty list uchar int vertex_indices\nend_header\n");
  file.points(model, binary);
  if (!binary) file.elements(model, "3 ");
  for (const auto& element : model.elements)
    if (binary) {
      file.bytes(std::uint8_t{3});
      for (const int corner : element) file.bytes(corner);
    }
  return {"s_" + format + ".ply", file.str(), false, !binary};
}

inline Sample stl_sample(bool binary, Variation variation = {}) {
  variation.corner = -1;  // there are no indices
  const Model model(false, variation);
  Contents file;
  // A name that begins with solid says nothing.
  file.text(binary ? "solid" + std::string(75, ' ') : "solid square\n");
  if (binary) file.bytes(static_cast<std::uint32_t>(model.element_count));
  for (const auto& element : model.elements) {
    if (!binary) file.text("facet normal 0 0 1\nouter loop\n");
    for (int c = 0; binary && c < 3; ++c) file.bytes(0.0f);
    for (const int corner : element) {
      if (!binary) file.text("vertex");
      for (int c = 0; c < 3; ++c)
        if (binary)
          file.bytes(static_cast<float>(model.points(corner, c)));
        else
          file.text(" ").number(model.points(corner, c));
      if (!binary) file.text("\n");
    }
    if (binary)
      file.bytes(std::uint16_t{0});
    else
      file.text("endloop\nendfacet\n");
  }
  if (!binary) file.text("endsolid square\n");
  return {binary ? "s_binary.stl" : "s_text.stl", file.str(), false, !binary, false, binary};
}

}  // namespace isostretch::mesh::test
