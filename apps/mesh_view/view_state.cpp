// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_state.h"

#include <algorithm>

namespace filmsticking::app {
namespace {

constexpr double kLeastPointSize = 1, kMostPointSize = 20;  // pixels

struct Key {
  const char* name;  ///< X's
  Action (*press)(const Scope&, ViewState&);
};

Action toggle(bool& what) {
  what = !what;
  return Action::Draw;
}

Action show_film(std::size_t film, ViewState& state) {
  state.playing = false;
  state.film = film;
  return Action::Draw;
}

Action resize_points(double by, ViewState& state) {
  state.point_size = std::clamp(state.point_size + by, kLeastPointSize, kMostPointSize);
  return Action::Draw;
}

Action next_paint(const Scope& scope, ViewState& state) {
  const auto now = std::find(scope.paints.begin(), scope.paints.end(), state.paint);
  state.paint =
      now == scope.paints.end() || now + 1 == scope.paints.end() ? scope.paints.front() : *(now + 1);
  return Action::Draw;
}

Action start_or_stop(const Scope& scope, ViewState& state) {
  if (scope.films < 2) return Action::None;
  if (!state.playing && state.film + 1 == scope.films) state.film = 0;  // from the start again
  return toggle(state.playing);
}

constexpr Key kKeys[] = {
    {"Right",
     [](const Scope& scope, ViewState& state) {
       return state.film + 1 < scope.films ? show_film(state.film + 1, state) : Action::None;
     }},
    {"Left",
     [](const Scope&, ViewState& state) {
       return state.film > 0 ? show_film(state.film - 1, state) : Action::None;
     }},
    {"Home", [](const Scope&, ViewState& state) { return show_film(0, state); }},
    {"End", [](const Scope& scope,
               ViewState& state) { return show_film(scope.films > 0 ? scope.films - 1 : 0, state); }},
    {"space", start_or_stop},
    {"m", [](const Scope&, ViewState& state) { return toggle(state.surface); }},
    {"p", [](const Scope&, ViewState& state) { return toggle(state.points); }},
    {"b", [](const Scope&, ViewState& state) { return toggle(state.holes); }},
    {"w", [](const Scope&, ViewState& state) { return toggle(state.edges); }},
    {"c", next_paint},
    {"plus", [](const Scope&, ViewState& state) { return resize_points(1, state); }},
    {"minus", [](const Scope&, ViewState& state) { return resize_points(-1, state); }},
    {"r", [](const Scope&, ViewState&) { return Action::ResetView; }},
    {"j", [](const Scope&, ViewState&) { return Action::Screenshot; }},
    {"h", [](const Scope&, ViewState& state) { return toggle(state.help); }},
    {"q", [](const Scope&, ViewState&) { return Action::Quit; }},
};

const Key* find(const std::string& name) {
  const auto key =
      std::find_if(std::begin(kKeys), std::end(kKeys), [&](const Key& k) { return k.name == name; });
  return key == std::end(kKeys) ? nullptr : key;
}

}  // namespace

Action press(const std::string& key, const Scope& scope, ViewState& state) {
  const Key* known = find(key);
  return known ? known->press(scope, state) : Action::None;
}

void play_on(const Scope& scope, ViewState& state) {
  if (state.film + 1 < scope.films) ++state.film;
  if (state.film + 1 >= scope.films) state.playing = false;
}

bool is_key(const std::string& key) { return find(key) != nullptr; }

std::string key_help() {
  return "Right, Left   next, previous step\n"
         "Home, End     first, last step\n"
         "space         play the steps, or stop\n"
         "m             mesh on or off\n"
         "p             points on or off\n"
         "b             edges of holes on or off\n"
         "w             edges of triangles on or off\n"
         "c             next colours: plain, the files', distances\n"
         "plus, minus   larger, smaller points\n"
         "r             first view again\n"
         "j             write a picture\n"
         "h             these keys on or off\n"
         "q             quit\n"
         "mouse         left: turn, middle: move, right or wheel: zoom\n";
}

}  // namespace filmsticking::app
