// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>

#include "stream/frame_source.h"
#include "stream/stream_error.h"
#include "support/scratch_folder.h"

namespace filmsticking::stream {
namespace {

TEST(OpenniSource, AFileThatIsNoRecordingIsRefused) {
  const test::ScratchFolder folder;
  std::ofstream(folder / "noise.oni") << "noise";
  EXPECT_THROW(openni_source(folder / "noise.oni"), StreamError);
}

}  // namespace
}  // namespace filmsticking::stream
