// SPDX-License-Identifier: GPL-3.0-or-later
// pcd_to_mesh where something goes wrong: input without end, files that end too soon, a full disk, signals.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "io/formats.h"
#include "support/run_program.h"
#include "tools/io/broken_files.h"

namespace filmsticking::test {
namespace {

namespace fs = std::filesystem;

const std::string kBunny = TEST_DATA "/bun0.pcd", kSpot = TEST_DATA "/spot_10k.ply";

Outcome shell(const std::string& command, const std::function<void(pid_t)>& while_running = nullptr) {
  return run_program({"/bin/sh", "-c", command}, while_running);
}

void expect_one_sentence(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("pcd_to_mesh: ", 0), 0u) << outcome.err;
  EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST(Faults, EndlessStandardInputIsRefusedAtABound) {
  const ScratchFolder folder;
  for (const char* endless : {"/dev/zero", "/dev/urandom"}) {
    const Outcome outcome =
        shell(PCD_TO_MESH " - " + (folder / "mesh.ply") + " --max-memory 20 < " + endless);
    EXPECT_EQ(outcome.status, 1);
    expect_one_sentence(outcome, "larger than 20 MB");
  }
  EXPECT_EQ(folder.count(), 0u);
}

TEST(Faults, WhatIsNoFileIsNotRead) {
  const ScratchFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe.ply").c_str(), 0600), 0);
  fs::create_directory(folder / "folder.ply");
  for (const std::string& input : {folder / "pipe.ply", folder / "folder.ply", std::string("/dev/zero")}) {
    const Outcome outcome = run_program({PCD_TO_MESH, input, folder / "mesh.ply"});
    EXPECT_EQ(outcome.status, 1);
    expect_one_sentence(outcome, "it is not a file");
  }
  const Outcome outcome = shell(PCD_TO_MESH " - " + (folder / "mesh.ply") + " < " + folder.path().string());
  EXPECT_EQ(outcome.status, 1);
  expect_one_sentence(outcome, "it cannot be read");
  EXPECT_EQ(folder.count(), 2u);
}

TEST(Faults, APipeIsRead) {
  const ScratchFolder folder;
  EXPECT_EQ(shell("cat " + kBunny + " | " PCD_TO_MESH " - " + (folder / "mesh.ply")).status, 0);
  EXPECT_GT(io::read_mesh(folder / "mesh.ply").polygons.size(), 0u);
}

TEST(Faults, MaxMemoryIsABound) {
  const ScratchFolder folder;
  for (const char* least : {"1", "5"}) {
    const Outcome outcome = run_program({PCD_TO_MESH, kSpot, folder / "mesh.ply", "--max-memory", least});
    EXPECT_EQ(outcome.status, 1);
    expect_one_sentence(outcome, "memory");
  }
  EXPECT_EQ(folder.count(), 0u);
  EXPECT_EQ(run_program({PCD_TO_MESH, kSpot, folder / "mesh.ply", "--max-memory", "1000"}).status, 0);
  for (const char* nonsense : {"0", "-1", "much", ""})
    EXPECT_EQ(run_program({PCD_TO_MESH, kSpot, folder / "other.ply", "--max-memory", nonsense}).status, 2);
  EXPECT_EQ(folder.count(), 1u);
}

TEST(Faults, FilesThatEndTooSoonGiveAMessageEachAndNoMesh) {
  const ScratchFolder folder;
  std::vector<std::string> command = {PCD_TO_MESH};
  for (const Sample& sample : samples())
    for (std::size_t k = 1; k <= 12; ++k) {
      const std::string file = folder / (sample.name + "_" + std::to_string(k) + sample.extension);
      std::ofstream(file, std::ios::binary) << sample.bytes.substr(0, (sample.bytes.size() - 12) * k / 12);
      command.push_back(file);
    }
  const std::size_t files = command.size() - 1;
  command.push_back((folder / "meshes") + "/");
  const Outcome outcome = run_program(command);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(static_cast<std::size_t>(std::count(outcome.err.begin(), outcome.err.end(), '\n')), files);
  EXPECT_NE(outcome.out.find("0 of " + std::to_string(files) + " meshes written"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder / "meshes"));
}

TEST(Faults, AFullDiskIsSaidAndNothingIsLeft) {
  const ScratchFolder folder;
  fs::create_directory(folder / "disk");
  const std::string with_own_mounts = "unshare --mount --map-root-user sh -c '";
  if (shell(with_own_mounts + "mount -t tmpfs -o size=64k none " + (folder / "disk") + "'").status != 0)
    GTEST_SKIP() << "no file system can be mounted here";
  // The old mesh stays as it is, too.
  const Outcome outcome =
      shell(with_own_mounts + "cd " + folder.path().string() +
            " && mount -t tmpfs -o size=64k none disk && cd disk && echo old > mesh.ply && " PCD_TO_MESH " " +
            kSpot + " mesh.ply; echo $?; ls -A; cat mesh.ply'");
  EXPECT_EQ(outcome.out, "1\nmesh.ply\nold\n");
  EXPECT_NE(outcome.err.find("it cannot be written: No space left on device"), std::string::npos)
      << outcome.err;
}

/// Waits until a program has a handler of SIGTERM.
void wait_for_handler(pid_t program) {
  for (int i = 0; i < 6000; ++i) {
    std::ifstream status("/proc/" + std::to_string(program) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.rfind("SigCgt:", 0) == 0 && (std::stoull(line.substr(7), nullptr, 16) >> (SIGTERM - 1) & 1))
        return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

TEST(Faults, ASignalEndsTheWaitForStandardInput) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ScratchFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    const int writer = open((folder / "pipe").c_str(), O_RDWR | O_CLOEXEC);
    ASSERT_GE(writer, 0);
    ASSERT_EQ(write(writer, "0 0 0\n", 6), 6);
    const Outcome outcome = shell(
        "exec " PCD_TO_MESH " - " + (folder / "mesh.ply") + " < " + (folder / "pipe"), [&](pid_t program) {
          wait_for_handler(program);
          kill(program, signal);
          std::this_thread::sleep_for(std::chrono::milliseconds(200));
          close(writer);  // should the signal have come before the wait
        });
    EXPECT_EQ(outcome.status, 130);
    expect_one_sentence(outcome, "interrupted");
    EXPECT_EQ(folder.count(), 1u);
  }
}

TEST(Faults, ASignalAtAnyMomentLeavesAWholeMeshOrNone) {
  const ScratchFolder folder;
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_EQ(run_program({PCD_TO_MESH, kSpot, folder / "expected.ply"}).status, 0);
  const auto whole = std::chrono::steady_clock::now() - begin;
  const std::string expected = io::read_file(folder / "expected.ply"), mesh = folder / "mesh.ply";
  const int moments = 12;
  int written = 0, stopped = 0;
  for (const int signal : {SIGINT, SIGTERM, SIGKILL})
    for (int moment = 0; moment <= moments; ++moment) {
      const Outcome outcome = run_program({PCD_TO_MESH, kSpot, mesh}, [&](pid_t program) {
        std::this_thread::sleep_for(whole * moment / moments);
        kill(program, signal);
      });
      const bool by_default = outcome.status == 128 + signal;  // before it listens, or SIGKILL
      EXPECT_TRUE(outcome.status == 0 || outcome.status == 130 || by_default) << outcome.status;
      if (fs::exists(mesh)) {
        EXPECT_TRUE(io::read_file(mesh) == expected);
        ++written;
      } else {
        EXPECT_NE(outcome.status, 0);
        ++stopped;
      }
      fs::remove(mesh);
      ASSERT_TRUE(signal == SIGKILL || folder.count() == 1u) << "something is left beside the mesh";
    }
  EXPECT_GT(stopped, 0);
  RecordProperty("written", written);
}

}  // namespace
}  // namespace filmsticking::test
