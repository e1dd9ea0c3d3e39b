#include "tools/experiments/window/accumulator_pictures.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "core/files/csv.hpp"

namespace lookout::tools {
namespace {

constexpr int kColumns = 314;
constexpr int kRows = 200;

std::map<std::int64_t, double> coarsened(const tracking::HoughInitiator& method,
                                         const tracking::LineGrid& picture) {
  std::vector<tracking::LineVote> cells;
  method.append_cells(cells);
  std::map<std::int64_t, double> largest;
  for (const tracking::LineVote& vote : cells) {
    const tracking::LineCell cell = picture.cell_of(method.grid().centre(vote.cell));
    if (!picture.contains(cell)) continue;
    double& value = largest[picture.index(cell)];
    value = std::max(value, vote.value);
  }
  return largest;
}

void write_row(core::CsvWriter& file, const tracking::NormalLine& line, double value, int target) {
  file.number(line.theta).number(line.rho).number(value).integer(target).end_row();
}

}  // namespace

void write_accumulator_picture(const tracking::HoughInitiator& method, const InitiationScene& scene,
                               const std::string& path) {
  const tracking::LineGrid picture(kColumns, kRows, method.grid().rho_max());
  core::CsvWriter file(path, "theta_rad,rho_m,value,target");
  for (const auto& [index, value] : coarsened(method, picture))
    write_row(file, picture.centre(picture.cell_at(index)), value, 0);
  const Eigen::Vector2d origin = method.grid_origin();
  for (std::size_t i = 0; i < scene.centres.size(); ++i) {
    const Eigen::Vector2d centre = scene.centres[i] - origin;
    write_row(file, *tracking::line_through(centre, centre + scene.directions[i]), 0.0, 1);
  }
  file.close();
}

}  // namespace lookout::tools
