// SPDX-License-Identifier: GPL-3.0-or-later
// The state of mesh_view and its keys, without a window.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace filmsticking::app {

/// The meaning of the colours.
enum class Paint {
  Plain,    ///< nothing: light faces with red backs
  Colours,  ///< the colours of the files
  Faces,    ///< the distance of each face to the reference
  Points,   ///< the distance of each point to the mesh
};

/// The contents of the window.
struct Scope {
  std::size_t films = 0;                    ///< meshes, one at a time
  bool points = false;                      ///< a cloud
  std::vector<Paint> paints{Paint::Plain};  ///< that the contents allow
};

/// The visible part of the contents.
struct ViewState {
  std::size_t film = 0;  ///< of the films
  bool surface = true;   ///< the film
  bool points = true;    ///< the cloud
  bool holes = true;     ///< edges of holes, and edges with more than two faces
  bool edges = false;    ///< of the triangles
  bool help = false;     ///< the text of the keys
  bool playing = false;  ///< one film after the other
  Paint paint = Paint::Plain;
  double point_size = 3;  ///< in pixels
};

/// The effect of a key on the window.
enum class Action {
  None,        ///< none: the key has no meaning
  Draw,        ///< show the changed state
  ResetView,   ///< restore the first view
  Screenshot,  ///< write a picture of the window
  Quit,
};

/// Changes the state as the key says. `key`: X's name of it, as "Right" or "b".
Action press(const std::string& key, const Scope& scope, ViewState& state);

/// Steps to the next film; stops playing at the last.
void play_on(const Scope& scope, ViewState& state);

/// Whether the key has a meaning in some state.
bool is_key(const std::string& key);

/// The keys and their effects, a line each.
std::string key_help();

}  // namespace filmsticking::app
