#pragma once

// One small mesh in every format and variant, written number by number, with faults to order.
#include "meshes.hpp"

#include <isostretch/mesh_io/io.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <string>
#include <vector>

namespace isostretch::mesh::test {

// What a sample says; the defaults are a good mesh.
struct Variation {
  double coordinate = 0.125;   // x of the first vertex
  int corner = -1;             // the last of the last element, from 0; -1: as it should be
  std::int64_t vertices = -1;  // the number that the file claims; -1: as it should be
  std::int64_t elements = -1;
  bool without_elements = false;  // and the claim is 0
};

struct Sample {
  std::string name;  // with the extension, which tells the format
  std::string contents;
  bool tets = false;
  bool text = true;     // messages are by line; otherwise by byte, but for headers
  bool indexed = true;  // corners are indices
  bool counted = true;  // the file claims numbers of vertices and elements
};

inline SurfaceMesh sample_surface() {
  return surface({0.125, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3});
}

inline TetMesh sample_tets() {
  return {rows<Points3>({0.125, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}),
          rows<Tets>({0, 1, 2, 3, 1, 2, 3, 4})};
}

// The sample mesh with the faults ordered, in the terms that formats share.
struct Model {
  Points3 points;
  std::vector<std::vector<int>> elements;
  std::int64_t point_count;
  std::int64_t element_count;
  int corners;

  explicit Model(bool tets, const Variation& variation) : corners(tets ? 4 : 3) {
    points = tets ? sample_tets().vertices : sample_surface().vertices;
    if (tets)
      take(sample_tets().tets);
    else
      take(sample_surface().triangles);
    points(0, 0) = variation.coordinate;
    if (variation.corner != -1) elements.back().back() = variation.corner;
    if (variation.without_elements) elements.clear();
    point_count = variation.vertices != -1 ? variation.vertices : points.rows();
    element_count =
        variation.elements != -1 ? variation.elements : static_cast<std::int64_t>(elements.size());
  }

  template <class Elements>
  void take(const Elements& rows_of_corners) {
    for (Eigen::Index e = 0; e < rows_of_corners.rows(); ++e)
      elements.emplace_back(rows_of_corners.data() + e * corners, rows_of_corners.data() + (e + 1) * corners);
  }
};

// Contents of a file, number by number.
class Contents {
 public:
  explicit Contents(std::endian order = std::endian::little) : order_(order) {}

  Contents& text(const std::string& text) {
    data_ += text;
    return *this;
  }
  Contents& number(double value) {
    char buffer[32];
    data_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
    return *this;
  }
  template <class T>
  Contents& bytes(T value) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (order_ != std::endian::native) std::reverse(raw.begin(), raw.end());
    data_.append(raw.data(), raw.size());
    return *this;
  }
  // Rows of a mesh in either coding.
  Contents& points(const Model& model, bool binary, const std::string& before = "",
                   const std::string& after = "") {
    for (Eigen::Index v = 0; v < model.points.rows(); ++v) {
      data_ += before;
      for (int c = 0; c < 3; ++c) {
        if (binary)
          bytes(model.points(v, c));
        else
          number(model.points(v, c)).text(c < 2 ? " " : "");
      }
      data_ += binary ? "" : after + "\n";
    }
    return *this;
  }
  Contents& elements(const Model& model, const std::string& before = "", int first = 0,
                     const std::string& after = "") {
    for (const auto& element : model.elements) {
      data_ += before;
      for (std::size_t c = 0; c < element.size(); ++c)
        data_ += std::string(c > 0 ? " " : "") + std::to_string(element[c] + first);
      data_ += after + "\n";
    }
    return *this;
  }

  const std::string& str() const { return data_; }

 private:
  std::endian order_;
  std::string data_;
};

inline std::string count_text(std::int64_t count) {
  return std::to_string(count);
}

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

inline std::string vtk_header(bool binary, const char* version = "3.0") {
  return std::string("# vtk DataFile Version ") + version + "\ntitle\n" + (binary ? "BINARY" : "ASCII") +
         "\n";
}

// Versions up to 4; polygons of a surface, cells of tetrahedra, both with what may surround them.
inline Sample vtk_sample(bool binary, bool tets, const Variation& variation = {}) {
  const Model model(tets, variation);
  Contents file(std::endian::big);
  const auto integer = [&](int value) {
    if (binary)
      file.bytes(value);
    else
      file.text(std::to_string(value) + " ");
  };
  const auto end_line = [&] { file.text("\n"); };
  file.text(vtk_header(binary) + (tets ? "DATASET UNSTRUCTURED_GRID\n" : "DATASET POLYDATA\n"));
  file.text("FIELD FieldData 1\nCYCLE 1 1 int\n");
  integer(3);
  end_line();
  file.text("POINTS " + count_text(model.point_count) + " double\n").points(model, binary);
  if (binary) end_line();
  file.text("METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\n");
  file.text((tets ? "CELLS " : "POLYGONS ") + count_text(model.element_count) + " " +
            count_text((model.corners + 1) * static_cast<std::int64_t>(model.elements.size())) + "\n");
  for (const auto& element : model.elements) {
    integer(model.corners);
    for (const int corner : element) integer(corner);
    if (!binary) end_line();
  }
  if (binary) end_line();
  if (tets) {
    file.text("CELL_TYPES " + std::to_string(model.elements.size()) + "\n");
    for (std::size_t e = 0; e < model.elements.size(); ++e) integer(10);
    end_line();
  }
  file.text("CELL_DATA 2\nwhatever follows\n");
  return {std::string("s_") + (binary ? "binary" : "text") + (tets ? "_tets.vtk" : "_surface.vtk"),
          file.str(), tets, !binary};
}

// The layout of version 5.
inline Sample vtk5_sample(bool binary, bool tets, const Variation& variation = {}) {
  const Model model(tets, variation);
  Contents file(std::endian::big);
  const auto wide = [&](std::int64_t value) {
    if (binary)
      file.bytes(value);
    else
      file.text(std::to_string(value) + " ");
  };
  file.text(vtk_header(binary, "5.1") + (tets ? "DATASET UNSTRUCTURED_GRID\n" : "DATASET POLYDATA\n"));
  file.text("POINTS " + count_text(model.point_count) + " double\n").points(model, binary);
  const auto corner_count = static_cast<std::int64_t>(model.elements.size()) * model.corners;
  file.text(std::string(binary ? "\n" : "") + (tets ? "CELLS " : "POLYGONS ") +
            count_text(model.element_count + (model.element_count < 0 ? 0 : 1)) + " " +
            count_text(corner_count) + "\nOFFSETS vtktypeint64\n");
  for (std::size_t e = 0; e <= model.elements.size(); ++e) wide(static_cast<std::int64_t>(e) * model.corners);
  file.text("\nCONNECTIVITY vtktypeint64\n");
  for (const auto& element : model.elements)
    for (const int corner : element) wide(corner);
  file.text("\n");
  if (tets) {
    file.text("CELL_TYPES " + std::to_string(model.elements.size()) + "\n");
    for (std::size_t e = 0; e < model.elements.size(); ++e)
      if (binary)
        file.bytes(std::int32_t{10});
      else
        file.text("10\n");
    file.text("\n");
  }
  return {std::string("s5_") + (binary ? "binary" : "text") + (tets ? "_tets.vtk" : "_surface.vtk"),
          file.str(), tets, !binary};
}

inline std::string base64(const std::string& bytes) {
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      bits = bits << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? alphabet[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

// `format`: ascii, binary (base64) or appended; binary ones with 32-bit headers in big endian.
inline Sample vtu_sample(const std::string& format, bool tets, const Variation& variation = {}) {
  const Model model(tets, variation);
  Contents points(std::endian::big), connectivity(std::endian::big), offsets(std::endian::big),
      types(std::endian::big);
  const bool ascii = format == "ascii";
  const auto integer = [&](Contents& array, std::int64_t value) {
    if (ascii)
      array.text(std::to_string(value) + " ");
    else
      array.bytes(static_cast<std::int32_t>(value));
  };
  points.points(model, !ascii);
  std::int64_t corners = 0;
  for (const auto& element : model.elements) {
    for (const int corner : element) integer(connectivity, corner);
    integer(offsets, corners += model.corners);
    if (ascii)
      types.text(tets ? "10 " : "5 ");
    else
      types.bytes(static_cast<std::uint8_t>(tets ? 10 : 5));
  }
  std::string appended;
  const auto array = [&](const std::string& attributes, const Contents& contents) {
    const std::string counted =
        Contents(std::endian::big).bytes(static_cast<std::uint32_t>(contents.str().size())).str() +
        contents.str();
    std::string tag = "<DataArray " + attributes + " format=\"" + format + "\"";
    if (format == "appended") tag += " offset='" + std::to_string(appended.size()) + "'/>\n";
    if (format == "appended") appended += counted;
    if (ascii) tag += ">\n" + contents.str() + "\n</DataArray>\n";
    if (format == "binary") tag += ">\n  " + base64(counted) + "\n</DataArray>\n";
    return tag;
  };
  std::string text =
      "<?xml version=\"1.0\"?>\n<!-- a < b -->\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
      "byte_order=\"BigEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
      count_text(model.point_count) + "\" NumberOfCells=\"" + count_text(model.element_count) +
      "\">\n<PointData><DataArray type=\"String\" Name=\"unread &amp; odd\" "
      "format=\"ascii\">x</DataArray></PointData>\n"
      "<Points>\n";
  text += array("type=\"Float64\" NumberOfComponents=\"3\"", points);
  text += "</Points>\n<Cells>\n" + array("type=\"Int32\" Name=\"connectivity\"", connectivity);
  text += array("type=\"Int32\" Name=\"offsets\"", offsets);
  text += array("type=\"UInt8\" Name=\"types\"", types);
  text += "</Cells>\n</Piece>\n</UnstructuredGrid>\n";
  if (format == "appended") text += "<AppendedData encoding=\"raw\">\n  _" + appended + "\n</AppendedData>\n";
  text += "</VTKFile>\n";
  return {"s_" + format + (tets ? "_tets.vtu" : "_surface.vtu"), text, tets, format != "appended"};
}

inline std::vector<Sample> all_samples(const Variation& variation = {}) {
  std::vector<Sample> samples = {obj_sample(variation), off_sample(variation), stl_sample(false, variation),
                                 stl_sample(true, variation)};
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
    samples.push_back(ply_sample(format, variation));
  for (const bool tets : {false, true}) {
    samples.push_back(medit_sample(tets, variation));
    for (const char* version : {"2.2", "4", "4.1"})
      for (const char* coding : {"text", "little", "big"})
        samples.push_back(msh_sample(version, coding, tets, variation));
    for (const bool binary : {false, true}) {
      samples.push_back(vtk_sample(binary, tets, variation));
      samples.push_back(vtk5_sample(binary, tets, variation));
    }
    for (const char* format : {"ascii", "binary", "appended"})
      samples.push_back(vtu_sample(format, tets, variation));
  }
  return samples;
}

inline bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

inline SurfaceMesh parse_surface(const std::string& name, const std::string& contents,
                                 const ReadOptions& options = {}) {
  if (ends_with(name, ".obj")) return parse_obj(contents, name, options);
  if (ends_with(name, ".off")) return parse_off(contents, name, options);
  if (ends_with(name, ".ply")) return parse_ply(contents, name, options);
  if (ends_with(name, ".stl")) return parse_stl(contents, name, options);
  if (ends_with(name, ".msh")) return parse_msh_surface(contents, name, options);
  if (ends_with(name, ".mesh")) return parse_medit_surface(contents, name, options);
  if (ends_with(name, ".vtk")) return parse_vtk_surface(contents, name, options);
  return parse_vtu_surface(contents, name, options);
}

inline TetMesh parse_tets(const std::string& name, const std::string& contents,
                          const ReadOptions& options = {}) {
  if (ends_with(name, ".msh")) return parse_msh_tets(contents, name, options);
  if (ends_with(name, ".mesh")) return parse_medit_tets(contents, name, options);
  if (ends_with(name, ".vtk")) return parse_vtk_tets(contents, name, options);
  return parse_vtu_tets(contents, name, options);
}

}  // namespace isostretch::mesh::test
