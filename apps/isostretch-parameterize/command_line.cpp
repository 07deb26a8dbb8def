#include "command_line.hpp"

#include "choice_names.hpp"
#include "common/energy_choice.hpp"
#include "common/exit_code.hpp"
#include "common/numbers.hpp"
#include "common/validators.hpp"
#include "pin_text.hpp"

#include <iostream>

namespace isostretch::app::parameterize {

void CommandLine::declare(CLI::App& cli) {
  declare_files(cli);
  declare_cut(cli);
  declare_energy(cli);
  declare_layout(cli);
  declare_pins(cli);
  declare_solve(cli);
}

void CommandLine::declare_files(CLI::App& cli) {
  cli.option_defaults()->group("Files");
  cli.add_option("model", model_, "Surface to flatten: OBJ, OFF, PLY, STL, MSH, MESH, VTK or VTU")
      ->required()
      ->type_name("FILE");
  cli.add_option("-o,--out", out_,
                 "Folder for <model>_uv.obj, summary.json, trace.csv, report.html and pictures")
      ->type_name("FOLDER");
  cli.add_flag("--check", check_,
               "Only print what is wrong with the model, element by element, and its topology");
  cli.add_flag("--triangulate", triangulate_,
               "Accepted for old scripts: faces of more than three corners are always cut");
  cli.add_flag(
      "--repair", repair_,
      "Orient triangles alike, drop duplicate and degenerate ones, split vertices where sheets touch");
  weld_option_ = declare_weld(cli, weld_);
  cli.add_flag("--no-picture", no_picture_,
               "Do not draw pictures, and write no report.html, which shows them");
  cli.add_flag("--glb", glb_, "Also write <model>_uv.glb with a checkerboard as texture");
}

void CommandLine::declare_cut(CLI::App& cli) {
  cli.option_defaults()->group("Cutting open");
  cli.add_flag("--no-cut", no_cut_, "Refuse what is not a disk instead of cutting it open");
  cli.add_option("--seams", seams_, "Cut where the input's uv is cut, or ignore it: input, ignore")
      ->check(one_of({"input", "ignore"}))
      ->type_name("WHICH")
      ->capture_default_str();
  cli.add_option("--holes", holes_, "Boundary loops inside to keep as holes, not cut to: short, none, all")
      ->check(one_of(all_names(holes_names)))
      ->type_name("WHICH")
      ->capture_default_str();
  cli.add_option("--cut-tips", cut_tips_, "Ends of the cut that opens a closed surface of genus 0, at most")
      ->check(whole_number_between(2, 1000))
      ->type_name("N")
      ->capture_default_str();
  cli.add_option("--max-distortion", max_distortion_,
                 "Cut further until no length is stretched or shrunk by more than this factor")
      ->check(number_between(1.001, 1e12))
      ->type_name("X");
  cli.add_option("--max-cuts", max_cuts_, "Cuts that --max-distortion may add")
      ->check(whole_number_between(0, 1'000'000))
      ->type_name("N")
      ->capture_default_str();
}

void CommandLine::declare_layout(CLI::App& cli) {
  cli.option_defaults()->group("Layout");
  cli.add_option(
         "--boundary", boundary_,
         "free; fixed where the start has it; held on a circle or square: free, fixed, circle, square")
      ->check(one_of(all_names(boundary_names)))
      ->type_name("SHAPE")
      ->capture_default_str();
  cli.add_option("--corners", corners_, "Four boundary vertices for the corners of the square, in order")
      ->type_name("A,B,C,D");
  cli.add_option("--pack", pack_,
                 "square: charts side by side in a square; none: where they are; auto: square, but none when "
                 "the start "
                 "is the input's uv or one chart has pins")
      ->check(one_of(all_names(pack_names)))
      ->type_name("HOW")
      ->capture_default_str();
  cli.add_option(
         "--overlap", overlap_,
         "What to do about a chart that lies on itself: split it and pack the parts, or allow it; auto: "
         "split when charts are packed, unless --no-cut")
      ->check(one_of(all_names(overlap_names)))
      ->type_name("WHAT")
      ->capture_default_str();
  cli.add_option(
         "--uv-units", uv_units_,
         "square: uv from 0 to 1; model: lengths as on the model; area: total area 1; auto: square, but "
         "model with pins")
      ->check(one_of(all_names(uv_units_names)))
      ->type_name("UNITS")
      ->capture_default_str();
  cli.add_option("--margin", margin_, "Space around packed charts, as a fraction of the square")
      ->check(number_between(0.0, 0.25))
      ->type_name("X")
      ->capture_default_str();
}

void CommandLine::declare_energy(CLI::App& cli) {
  cli.option_defaults()->group("Energy");
  cli.add_option("-e,--energy", energy_, "Distortion energy; --list-energies shows all")
      ->type_name("NAME")
      ->capture_default_str();
  cli.add_option("-p,--param", parameters_,
                 "Parameters of the energy: name=value[,name=value...]; may be repeated")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
  cli.add_flag_callback(
         "--list-energies",
         [] {
           std::cout << energy_table(2) << std::flush;
           throw CLI::Success{};
         },
         "List the energies and their parameters, and exit")
      ->trigger_on_parse();
}

void CommandLine::declare_pins(CLI::App& cli) {
  cli.option_defaults()->group("Pins");
  cli.add_option("--pin", pins_,
                 "Keep a vertex (counted from 0) in its initial place, or put it at U,V; may be "
                 "repeated")
      ->allow_extra_args(false)
      ->type_name("VERTEX[:U,V]");
  cli.add_option("--soft-pin", soft_pins_, "Pull a vertex towards U,V with a weight (1); may be repeated")
      ->allow_extra_args(false)
      ->type_name("VERTEX:U,V[:WEIGHT]");
  cli.add_option("--horizontal", horizontal_,
                 "Vertices that come to lie at the same v, an edge or more; may be repeated")
      ->allow_extra_args(false)
      ->type_name("A,B[,C...]");
  cli.add_option("--vertical", vertical_, "The same at the same u")
      ->allow_extra_args(false)
      ->type_name("A,B[,C...]");
}

void CommandLine::declare_solve(CLI::App& cli) {
  cli.add_option("--initial", initial_, "Start from Tutte's embedding or the input's uv: tutte, input")
      ->check(one_of(all_names(initial_names)))
      ->type_name("START")
      ->capture_default_str();
  solver_flags_.declare(cli, ", with total area 1");
}

namespace {

std::vector<int> vertex_list(const std::string& text, const char* option) {
  std::vector<int> vertices;
  if (text.empty()) return vertices;
  for (const std::string& word : split(text, ',')) {
    const auto vertex = whole_number(word);
    if (!vertex || *vertex < 0) throw Error(std::string(option) + ": '" + word + "' is not a vertex number");
    vertices.push_back(*vertex);
  }
  return vertices;
}

void add_aligned(const std::vector<std::string>& texts, bool horizontal, Options& options) {
  const char* name = horizontal ? "--horizontal" : "--vertical";
  for (const std::string& text : texts) {
    options.aligned.push_back({vertex_list(text, name), horizontal});
    if (options.aligned.back().vertices.size() < 2)
      throw Error(std::string(name) + ": '" + text + "' names less than two vertices");
  }
}

void require_consistent(const Options& options) {
  if (!options.corners.empty() && options.boundary != Boundary::square)
    throw Error("--corners: only with --boundary square");
  if (!options.corners.empty() && options.corners.size() != 4)
    throw Error("--corners: " + std::to_string(options.corners.size()) +
                " vertices given, a square has four");
  const bool shaped = options.boundary == Boundary::circle || options.boundary == Boundary::square;
  if (shaped && options.initial == Initial::input)
    throw Error(
        "--boundary circle, square: the start puts the boundary there, which --initial input does not");
  if (options.uv_units == UvUnits::square && options.has_pins())
    throw Error("--uv-units square: where pins are is given in units of the model, or of total area 1");
  if (options.overlap == OverlapRule::split && !options.cut)
    throw Error("--overlap split: cuts, which --no-cut does not allow");
  if (options.overlap == OverlapRule::split && options.pack == Pack::none)
    throw Error("--overlap split: parts of a chart come apart only when they are packed");
  if (options.overlap == OverlapRule::split && (options.has_pins() || !options.aligned.empty()))
    throw Error(
        "--overlap split: packs the parts of charts, which moves vertices that are pinned or aligned");
  if (options.max_distortion > 0 && (options.initial == Initial::input || !options.cut))
    throw Error("--max-distortion: cuts, which --initial input and --no-cut do not allow");
  if (options.max_distortion > 0 && (options.has_pins() || !options.aligned.empty()))
    throw Error("--max-distortion: cuts, and may double vertices that are pinned or aligned");
  if (options.max_distortion > 0 && options.boundary != Boundary::free)
    throw Error("--max-distortion: cuts, and needs --boundary free");
}

}  // namespace

Options CommandLine::options() const {
  return with_error_kind(ErrorKind::misuse, [this] {
    Options options;
    options.model = model_;
    options.out = out_;
    options.initial = choice_of(initial_names, initial_);
    options.repair = repair_;
    options.weld = weld_tolerance(weld_option_, weld_);
    options.cut = !no_cut_;
    options.input_seams = seams_ == "input";
    options.holes = choice_of(holes_names, holes_);
    options.cut_tips = cut_tips_;
    options.max_distortion = max_distortion_;
    options.max_cuts = max_cuts_;
    options.boundary = choice_of(boundary_names, boundary_);
    options.corners = vertex_list(corners_, "--corners");
    options.pack = choice_of(pack_names, pack_);
    options.margin = margin_;
    options.overlap = choice_of(overlap_names, overlap_);
    options.uv_units = choice_of(uv_units_names, uv_units_);
    options.picture = !no_picture_;
    options.glb = glb_;
    options.pins = parse_pins(pins_);
    options.soft_pins = parse_soft_pins(soft_pins_);
    add_aligned(horizontal_, true, options);
    add_aligned(vertical_, false, options);
    solver_flags_.apply(options.newton);
    options.check = check_;
    if (options.out.empty() && !options.check) throw Error("--out: a folder for the results is needed");
    require_consistent(options);
    return options;
  });
}

energies::AnyEnergy CommandLine::energy() const {
  return with_error_kind(ErrorKind::misuse, [this] {
    const auto parameters = parse_parameters(parameters_);
    try {
      return choose_energy(energy_, parameters, 2);
    } catch (const Error& error) {
      throw Error(std::string("--energy: ") + error.what());
    }
  });
}

}  // namespace isostretch::app::parameterize
