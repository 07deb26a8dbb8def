#include <isostretch/figures/animation.hpp>

#include <isostretch/core/base64.hpp>
#include <isostretch/core/error.hpp>
#include <isostretch/core/text.hpp>
#include <isostretch/figures/html.hpp>
#include <isostretch/figures/solid_figure.hpp>
#include <isostretch/mesh_io/io.hpp>

#include <algorithm>
#include <utility>

namespace isostretch::figures {
namespace {

// Pictures by turns in one place. The names it adds to the page begin with "frame-".
constexpr const char* player = R"(<div class="player"><button type="button" id="frame-play">Play</button>
<input type="range" id="frame-slider" min="0" value="0" aria-label="frame"><output id="frame-label"></output></div>
<script>
(() => {
  const images = [...document.querySelectorAll('.frame-picture')];
  const slider = document.getElementById('frame-slider'), label = document.getElementById('frame-label');
  const button = document.getElementById('frame-play');
  let timer = 0;
  const show = (i) => {
    images.forEach((image, k) => { image.hidden = k !== i; });
    slider.value = i;
    label.textContent = images[i].alt;
  };
  const stop = () => { clearInterval(timer); timer = 0; button.textContent = 'Play'; };
  slider.max = images.length - 1;
  slider.addEventListener('input', () => { stop(); show(Number(slider.value)); });
  button.addEventListener('click', () => {
    if (timer) return stop();
    button.textContent = 'Stop';
    timer = setInterval(() => show((Number(slider.value) + 1) % images.length), 250);
  });
  show(images.length - 1);
})();
</script>
)";

}  // namespace

Animation::Animation(const deformation::SolidModel& body, std::vector<std::array<int, 2>> lines, int up)
    : body_(body), lines_(std::move(lines)), up_(up) {}

void Animation::add(int number, double time, const Vector& positions,
                    const deformation::StrainField& strain) {
  numbers_.push_back(number);
  states_.push_back({formatted("frame %d, time %.4g", number, time),
                     surface_points(body_, body_.points(positions)), strain.length_change, strain.inverted});
}

std::string Animation::glb_name(const std::string& name) const {
  if (states_.empty() || (!is_whole() && states_.size() == 1)) return {};
  return name + (is_whole() ? ".glb" : formatted("_%04d_on.glb", numbers_.front()));
}

std::string Animation::glb_notice(const std::string& file) const {
  if (is_whole()) return {};
  return file + formatted(" holds frames %d to %d, those of this run", numbers_.front(), numbers_.back());
}

std::string Animation::glb() const {
  constexpr double frames_a_second = 4;
  mesh::SurfaceMesh surface;
  surface.vertices = surface_points(body_, body_.nodes);
  surface.triangles = body_.surface.mesh.triangles;
  std::vector<mesh::GlbFrame> frames;
  for (std::size_t i = 0; i < states_.size(); ++i)
    frames.push_back({(numbers_[i] - numbers_.front()) / frames_a_second, states_[i].vertices});
  return mesh::format_glb_animation(surface, frames);
}

std::vector<std::size_t> Animation::shown() const {
  std::vector<std::size_t> chosen;
  const std::size_t count = states_.size(), steps = std::min(count, most_shown);
  for (std::size_t i = 0; i < steps; ++i)
    chosen.push_back(steps == 1 ? 0 : (i * (count - 1) + (steps - 1) / 2) / (steps - 1));
  return chosen;
}

std::string Animation::preview() const {
  if (states_.size() < 2) return {};
  const std::vector<std::size_t> chosen = shown();
  DeformationFigure figure{.title = {},
                           .subtitle = {},
                           .states = {},
                           .triangles = body_.surface.mesh.triangles,
                           .element = body_.surface.element,
                           .volumes = body_.volumes(),
                           .lines = lines_,
                           .flat = body_.dim == 2,
                           .up = up_};
  for (const std::size_t i : chosen) figure.states.push_back(states_[i]);
  std::string content;
  const std::vector<std::string> pictures = draw_each(figure);
  for (std::size_t i = 0; i < pictures.size(); ++i)
    content += "<img class=\"frame-picture\"" + std::string(i + 1 < pictures.size() ? " hidden" : "") +
               " alt=\"" + html::escaped(figure.states[i].caption) + "\" src=\"data:image/png;base64," +
               base64(pictures[i]) + "\">\n";
  std::string caption = "The frames, coloured as in the pictures: pale where lengths are kept.";
  if (numbers_.front() != 0) caption += formatted(" Those of this run, from frame %d on.", numbers_.front());
  if (chosen.size() < states_.size())
    caption += formatted(" %zu of %zu frames are shown.", chosen.size(), states_.size());
  return html::block("figure", content + player + html::element("figcaption", html::escaped(caption)));
}

std::string add_glb(OutputFolder& folder, const Animation& animation, const std::string& name) {
  const std::string file = animation.glb_name(name);
  if (file.empty()) return name + ".glb is not written: this run has made no frame";
  try {
    folder.add(file, animation.glb());
  } catch (const Error& error) {
    return file + " is not written: " + error.what();
  }
  return animation.glb_notice(file);
}

}  // namespace isostretch::figures
