#include <dlfcn.h>
#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "coilwright/video/vision.hpp"

namespace coilwright::video {

const Vision& load_vision() {
  constexpr const char* module_name = "libcoilwright_opencv.so";
  void* module = dlopen(module_name, RTLD_NOW | RTLD_LOCAL);  // beside the program, by its run path; never unloaded
  if (module == nullptr) {
    const std::string_view reason = dlerror();
    constexpr std::string_view cure =
        "films are read with OpenCV, which is not here: install the package coilwright-films; or, to build it, "
        "libopencv-contrib-dev, libopencv-videoio-dev and libopencv-calib3d-dev (scripts/setup.sh films), and build "
        "again";
    throw std::runtime_error(fmt::format("{} ({})", cure, reason));
  }
  const auto vision = reinterpret_cast<const Vision* (*)()>(dlsym(module, "coilwright_vision"));
  if (vision == nullptr) throw std::runtime_error(fmt::format("{} is of another version of Coilwright", module_name));
  return *vision();
}

}  // namespace coilwright::video
