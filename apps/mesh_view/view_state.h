// SPDX-License-Identifier: GPL-3.0-or-later
// What mesh_view shows and how keys change it, without a window.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace filmsticking::app {

/// What the colours tell.
enum class Paint {
  Plain,    ///< nothing: light faces with red backs
  Colours,  ///< the colours of the files
  Faces,    ///< the distance of each face to the reference
  Points,   ///< the distance of each point to the mesh
};

/// What there is to show.
struct Scope {
  std::size_t films = 0;                    ///< meshes, one at a time
  bool points = false;                      ///< a cloud
  std::vector<Paint> paints{Paint::Plain};  ///< that make sense
};

/// What is shown.
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

/// What is to be done after a key.
enum class Action {
  None,        ///< nothing; the key has no meaning
  Draw,        ///< show the changed state
  ResetView,   ///< look from where the program looked first
  Screenshot,  ///< write a picture of the window
  Quit,
};

/// Changes the state as the key says. `key`: X's name of it, as "Right" or "b".
Action press(const std::string& key, const Scope& scope, ViewState& state);

/// Goes on to the next film, and stops playing at the last one.
void play_on(const Scope& scope, ViewState& state);

/// Whether any state gives the key a meaning.
bool is_key(const std::string& key);

/// The keys and what they do, a line each.
std::string key_help();

}  // namespace filmsticking::app
