// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes that PCL packs are unpacked, in pieces of any size.
#include "io/lzf.h"

#include <gtest/gtest.h>
#include <pcl/io/lzf.h>

#include <algorithm>
#include <random>
#include <string>

#include "io/io_error.h"

namespace filmsticking::test {
namespace {

std::string packed(const std::string& bytes) {
  std::string to(2 * bytes.size() + 64, '\0');
  to.resize(pcl::lzfCompress(bytes.data(), static_cast<unsigned>(bytes.size()), to.data(),
                             static_cast<unsigned>(to.size())));
  EXPECT_FALSE(to.empty());
  return to;
}

std::string unpacked(const std::string& bytes, std::size_t size, std::size_t piece) {
  io::LzfReader reader(bytes);
  std::string all;
  while (all.size() < size) {
    const std::size_t part = std::min(piece, size - all.size());
    all.append(reader.take(part), part);
  }
  EXPECT_TRUE(reader.at_end());
  return all;
}

TEST(Lzf, WhatPclPacksComesBackInPiecesOfAnySize) {
  std::mt19937 random(1);
  for (const unsigned letters : {1U, 2U, 5U, 256U}) {
    std::string bytes(600000, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i)  // with repeats near and far
      bytes[i] = i > 9000 && random() % 3 > 0 ? bytes[i - 7777] : static_cast<char>(random() % letters);
    const std::string small = packed(bytes);
    for (const std::size_t piece : {std::size_t{97}, std::size_t{4096}, io::LzfReader::kMost})
      EXPECT_TRUE(unpacked(small, bytes.size(), piece) == bytes) << letters << " letters, " << piece;
  }
}

TEST(Lzf, BrokenBytesAreRefused) {
  for (const std::string& bytes : {std::string(), std::string("\5ab"), std::string("\x20"),
                                   std::string("\0a\x3f\xff", 4), std::string("\0a\xe0", 3)}) {
    io::LzfReader reader(bytes);
    EXPECT_THROW(reader.take(64), io::IoError);
  }
}

}  // namespace
}  // namespace filmsticking::test
