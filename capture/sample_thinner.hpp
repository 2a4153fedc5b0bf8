// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "capture/sample_point.hpp"

namespace gonogo::oracle {

// Samples as records for a drawing: traverses, which have no feed, from one to the next, each with
// the number of its sample as "x-sample". A sample within a thousandth of the way between its
// neighbours is left out.
class SampleThinner {
 public:
  // `seen`: axes that have a column. `marked`: the sample that is kept in any case.
  SampleThinner(reference::AxisSet seen, std::uint64_t header_lines,
                std::optional<std::size_t> marked)
      : seen_(seen), header_lines_(header_lines), marked_(marked) {}
  void add(const Sample& sample);
  std::vector<std::string> finish();

 private:
  bool on_the_way(const Sample& next) const;
  void put(const Sample& sample);

  reference::AxisSet seen_;
  std::uint64_t header_lines_;
  std::optional<std::size_t> marked_;
  bool begun_ = false;
  std::optional<Sample> last_;  // that was kept
  std::vector<Sample> held_;    // since then
  std::vector<std::string> kept_;
};

}  // namespace gonogo::oracle
