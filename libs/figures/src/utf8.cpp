#include <isostretch/figures/utf8.hpp>

#include <nlohmann/json.hpp>

namespace isostretch::figures {

std::string valid_utf8(std::string_view text) {
  using nlohmann::json;
  // JSON has to be UTF-8, so its writer can do this; reading takes the quotes and escapes off again.
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

}  // namespace isostretch::figures
