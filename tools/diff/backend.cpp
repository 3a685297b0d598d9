#include "tools/diff/backend.h"

#include "model/base/input_error.h"
#include "tools/rtl/rtl_comparison.h"

#include <sstream>

namespace ffgpu::tools {
namespace {

constexpr std::string_view Rtl = "rtl";

std::vector<std::string> units_of(const std::string& name) {
    if (name == Rtl) return {"all"};
    std::vector<std::string> units;
    std::istringstream list(name.substr(Rtl.size() + 1));
    for (std::string unit; std::getline(list, unit, ',');)
        units.push_back(unit);
    return units;
}

} // namespace

Backend::Backend(const std::string& name, const std::string& waves, rtl::WaveCycles wave_cycles) {
    if (name == "functional") {
        stages_ = &FastStages;
    } else if (name == "reference") {
        stages_ = &ReferenceStages;
    } else if (name == Rtl || name.starts_with("rtl:")) {
        rtl_ =
            open_rtl_stages({.units = units_of(name), .waves = waves, .wave_cycles = wave_cycles});
        stages_ = &rtl_->table();
    } else {
        throw InputError("--backend " + name +
                         ": expected functional, reference, rtl or rtl:UNIT,UNIT");
    }
}

} // namespace ffgpu::tools
