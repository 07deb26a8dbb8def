#pragma once

// The sample mesh in VTK, in both of its layouts, and in VTU.
#include "contents.hpp"
#include "sample_mesh.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

namespace isostretch::mesh::test {

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

}  // namespace isostretch::mesh::test
