#pragma once
#include "cg/blobs.hpp"
#include "md/star_consumers.hpp"
#include "scratch_directory.hpp"
#include <gtest/gtest.h>
#include <optional>

namespace mesobridge::cg::test {

/// A run of LAMMPS whose molecules are written down as blobs.
class BlobRun : public ::testing::Test {
 protected:
  /// What writes the frames down, and stops the run at a step.
  md::StarConsumers recorder(md::StarPolymer const& star, std::optional<std::int64_t> stop_at) {
    frames_.clear(), safe_.clear();
    maker_.emplace(model_of(star));
    return {.frames =
                [this](md::MoleculeFrame const& frame) {
                  last_ = frame;
                  frames_.push_back(gather_blobs(world_, frame, maker_->blobs(frame)));
                },
            .checkpoint = [this] { safe_ = frames_; },
            .steps = [stop_at](std::int64_t done, std::int64_t) { return !stop_at || done < *stop_at; }};
  }

  md::MpiWorld world_;
  tests::ScratchDirectory folder_;
  std::vector<BlobFrame> frames_, safe_; ///< all, and those of the last checkpoint
  md::MoleculeFrame last_;

 private:
  std::optional<BlobMaker> maker_;
};

} // namespace mesobridge::cg::test
