#include "tools/views/view.h"

#include "model/base/input_error.h"
#include "tools/config/nearest_name.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace ffgpu::tools {
namespace {

struct HeatView {
    std::string_view name;
    HeatMap map;
};
constexpr std::array<HeatView, 2> HeatViews{
    {{"level", HeatMap::Level}, {"coverage", HeatMap::Covered}}};

std::vector<std::string> all_names() {
    std::vector<std::string> names;
    names.reserve(ViewTable.size() + HeatViews.size());
    for (const ViewInfo& view : ViewTable)
        names.emplace_back(view.name);
    for (const HeatView& view : HeatViews)
        names.emplace_back(view.name);
    return names;
}

void add(const std::string& name, WantedViews& wanted) {
    const auto* const view = std::ranges::find(ViewTable, name, &ViewInfo::name);
    const auto* const heat = std::ranges::find(HeatViews, name, &HeatView::name);
    if (view != ViewTable.end())
        wanted.views.insert(static_cast<View>(view - ViewTable.begin()));
    else if (heat != HeatViews.end())
        wanted.heat_maps.insert(heat->map);
    else
        throw InputError("--view: unknown view " + name + "; did you mean " +
                         nearest_name(name, all_names()) + "?");
}

} // namespace

WantedViews parse_views(const std::string& names) {
    WantedViews wanted;
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');) {
        std::ranges::replace(name, '-', '_');
        add(name, wanted);
    }
    return wanted;
}

std::string view_names() {
    std::string text;
    for (const std::string& name : all_names())
        text.append(text.empty() ? "" : ", ").append(name);
    return text;
}

} // namespace ffgpu::tools
