// SPDX-License-Identifier: GPL-3.0-or-later
// The page that page.cpp writes: shows the numbers of its elements with three.js.
// What is shown may be named behind a # in the address: colours=truth_distances&hole=1&view=30,20&hide=backs,points
'use strict';
(function () {
    const FRONT = [0.88, 0.86, 0.82], BACK = [0.76, 0.5, 0.48];
  const HOLE = [0.9, 0, 0], SURPLUS = [0.6, 0, 0.8], MEETING = [1, 0.6, 0], POINT = [0.05, 0.25, 0.55];
  // YlGnBu of ColorBrewer, as in scene/drawing.cpp.
  const SCALE = [[1, 1, 0.8], [0.631, 0.855, 0.706], [0.255, 0.714, 0.769], [0.173, 0.498, 0.722], [0.145, 0.204, 0.58]];
  const FLIGHT = 600;  // milliseconds
  const NEARER = 0.004;  // what lies on faces is drawn so much before them, in sizes of the mesh
  const AWAY = 10;       // from the camera to what it turns around
  const radius = () => facts.radius || 0.5;

  const $ = (id) => document.getElementById(id);
  const facts = JSON.parse($('facts').textContent);
  const asked = new URLSearchParams(location.hash.slice(1));
  const css = (colour) => 'rgb(' + colour.map((c) => Math.round(255 * c)) + ')';

  /** The bytes of an element, in numbers of a type; empty without such an element. */
  function numbers(id, Type) {
    const element = $(id);
    if (!element) return new Type(0);
    const text = atob(element.textContent);
    element.textContent = '';
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    return new Type(bytes.buffer);
  }

  function make(tag, text, parent) {
    const element = document.createElement(tag);
    if (text !== undefined) element.textContent = text;
    if (parent) parent.appendChild(element);
    return element;
  }

  const short = (x) => String(Number(Number(x).toPrecision(4)));

  // ---- The scene ----

  const positions = numbers('positions', Float32Array), faces = numbers('faces', Uint32Array);
  const uniforms = {
    front: { value: new THREE.Vector3(...FRONT) }, back: { value: new THREE.Vector3(...BACK) },
    meeting: { value: new THREE.Vector3(...MEETING) }, point: { value: new THREE.Vector3(...POINT) },
    scale: { value: SCALE.map((c) => new THREE.Vector3(...c)) },
    source: { value: 0 }, nearer: { value: 0 }, backs: { value: true }, meetings: { value: true }, edges: { value: false },
    size: { value: 3 },
  };
  const RAMP = `
    uniform vec3 scale[5];
    vec3 ramp(float share) {
      float place = clamp(share, 0.0, 1.0) * 4.0;
      vec3 colour = scale[0];
      for (int i = 0; i < 4; ++i) colour = mix(colour, scale[i + 1], clamp(place - float(i), 0.0, 1.0));
      return colour;
    }`;

  /** Faces with corners of their own, so that each has its colours: truth, cloud, meeting, number of the corner. */
  function makeSurface() {
    const places = new Float32Array(3 * faces.length), marks = new Uint8Array(4 * faces.length);
    const truth = numbers('truth_distances', Uint8Array), cloud = numbers('cloud_distances', Uint8Array);
    for (let c = 0; c < faces.length; ++c) {
      const face = Math.floor(c / 3);
      for (let k = 0; k < 3; ++k) places[3 * c + k] = positions[3 * faces[c] + k];
      if (truth.length) marks[4 * c] = truth[face];
      if (cloud.length) marks[4 * c + 1] = cloud[face];
      marks[4 * c + 3] = 127 * (c % 3);
    }
    for (const face of numbers('meeting', Uint32Array))
      for (let k = 0; k < 3; ++k) marks[4 * (3 * face + k) + 2] = 255;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(places, 3));
    geometry.setAttribute('mark', new THREE.BufferAttribute(marks, 4, true));
    const material = new THREE.ShaderMaterial({
      uniforms: uniforms, side: THREE.DoubleSide, extensions: { derivatives: true },
      vertexShader: `
        attribute vec4 mark;
        varying vec4 vMark; varying vec3 vPlace; varying vec3 vCorner;
        void main() {
          vec4 place = modelViewMatrix * vec4(position, 1.0);
          vMark = mark; vPlace = place.xyz;
          vCorner = vec3(mark.w < 0.25, mark.w > 0.25 && mark.w < 0.75, mark.w > 0.75);
          gl_Position = projectionMatrix * place;
        }`,
      fragmentShader: RAMP + `
        uniform vec3 front, back, meeting;
        uniform int source;
        uniform bool backs, meetings, edges;
        varying vec4 vMark; varying vec3 vPlace; varying vec3 vCorner;
        void main() {
          vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
          // Points on either side of the surface are to be seen.
          if (source == 3 && mod(floor(gl_FragCoord.x) + floor(gl_FragCoord.y), 2.0) < 0.5) discard;
          bool plain = source == 0 || source == 3;
          vec3 colour = plain ? front : ramp(source == 1 ? vMark.x : vMark.y);
          if (plain && backs && !gl_FrontFacing) colour = back;
          if (plain && meetings && vMark.z > 0.5) colour = meeting;
          if (edges) {
            vec3 width = vCorner / fwidth(vCorner);
            colour *= mix(0.35, 1.0, clamp(min(min(width.x, width.y), width.z), 0.0, 1.0));
          }
          float light = abs(normal.z);
          gl_FragColor = vec4(colour * (light == light ? 0.4 + 0.6 * light : 1.0), 1.0);
        }`,
    });
    const surface = new THREE.Mesh(geometry, material);
    surface.frustumCulled = false;
    return surface;
  }

  function makePoints() {
    const places = numbers('points', Float32Array);
    if (!places.length) return null;
    const distances = numbers('point_distances', Uint8Array);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(places, 3));
    geometry.setAttribute('distance', new THREE.BufferAttribute(
        distances.length ? distances : new Uint8Array(places.length / 3), 1, true));
    const material = new THREE.ShaderMaterial({
      uniforms: uniforms,
      vertexShader: `
        attribute float distance;
        uniform float size, nearer;
        varying float vDistance;
        void main() {
          vDistance = distance;
          gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
          gl_Position.z -= nearer;
          gl_PointSize = size;
        }`,
      fragmentShader: RAMP + `
        uniform int source;
        uniform vec3 point;
        varying float vDistance;
        void main() { gl_FragColor = vec4(source == 3 ? ramp(vDistance) : point, 1.0); }`,
    });
    const points = new THREE.Points(geometry, material);
    points.frustumCulled = false;
    return points;
  }

  /** Lines of a width in pixels between pairs of vertices; null without any. */
  function makeLines(pairs, colour, width, through) {
    if (!pairs.length) return null;
    const ends = new Float32Array(3 * pairs.length);
    for (let i = 0; i < pairs.length; ++i)
      for (let k = 0; k < 3; ++k) ends[3 * i + k] = positions[3 * pairs[i] + k];
    const geometry = new THREE.LineSegmentsGeometry();
    geometry.setPositions(ends);
    const material = new THREE.LineMaterial({ color: new THREE.Color(...colour).getHex(), linewidth: width });
    material.depthTest = !through;
    material.onBeforeCompile = (shader) => {
      shader.uniforms.nearer = uniforms.nearer;
      shader.vertexShader = 'uniform float nearer;\n' +
          shader.vertexShader.replace('gl_Position = clip;', 'gl_Position = clip; gl_Position.z -= nearer;');
    };
    const lines = new THREE.LineSegments2(geometry, material);
    lines.frustumCulled = false;
    return lines;
  }

  // ---- The window ----

  const scene = new THREE.Scene();
  let renderer, camera, controls, drawn = false;

  function resize() {
    const width = $('view').clientWidth, height = $('view').clientHeight;
    renderer.setPixelRatio(window.devicePixelRatio || 1);
    renderer.setSize(width, height, false);
    uniforms.size.value = 3 * renderer.getPixelRatio();
    const half = 1.05 * radius(), tall = height >= width ? height / width : 1, wide = width > height ? width / height : 1;
    camera.left = -half * wide; camera.right = half * wide;
    camera.top = half * tall; camera.bottom = -half * tall;
    camera.updateProjectionMatrix();
    for (const child of scene.children)
      if (child.material.resolution) child.material.resolution.set(width, height);
    controls.handleResize();
    drawn = false;
  }

  /** Looks along -out at a place; `zoom` 1 shows the whole. */
  function place(target, out, zoom, up) {
    controls.target.copy(target);
    camera.position.copy(target).addScaledVector(out, AWAY);
    if (up) camera.up.copy(up);
    camera.zoom = zoom;
    camera.updateProjectionMatrix();
    controls.update();
    drawn = false;
  }

  /** The upright axis for a direction to look from. */
  function upFor(out) {
    const y = new THREE.Vector3(0, 1, 0);
    return Math.abs(out.dot(y)) > 0.98 ? new THREE.Vector3(0, 0, -Math.sign(out.y) || 1) : y;
  }

  let flight = null;
  function fly(target, out, zoom, at_once) {
    if (at_once || matchMedia('(prefers-reduced-motion: reduce)').matches)
      return place(target, out, zoom, upFor(out));
    const view = new THREE.Matrix4().lookAt(out, new THREE.Vector3(), upFor(out));
    flight = {
      from: { target: controls.target.clone(), zoom: camera.zoom, turn: camera.quaternion.clone() },
      to: { target: target, zoom: zoom, turn: new THREE.Quaternion().setFromRotationMatrix(view) },
    };
  }

  function step(now) {
    requestAnimationFrame(step);
    if (flight) {
      flight.begin = flight.begin || now;
      const share = Math.min((now - flight.begin) / FLIGHT, 1), t = share * share * (3 - 2 * share);
      const from = flight.from, to = flight.to, turn = from.turn.clone().slerp(to.turn, t);
      place(from.target.clone().lerp(to.target, t), new THREE.Vector3(0, 0, 1).applyQuaternion(turn),
            Math.pow(from.zoom, 1 - t) * Math.pow(to.zoom, t), new THREE.Vector3(0, 1, 0).applyQuaternion(turn));
      if (share === 1) flight = null;
    } else {
      controls.update();
    }
    if (!drawn) {
      // Who comes near sees less of what is before: a hole inside is not hidden.
      camera.near = Math.max(0.1, AWAY - 2.2 * radius() / camera.zoom);
      camera.updateProjectionMatrix();
      uniforms.nearer.value = 2 * NEARER / camera.zoom / (camera.far - camera.near);
      renderer.render(scene, camera);
      drawn = true;
      document.body.dataset.drawn = faces.length / 3;
    }
  }

  function direction(azimuth, elevation) {
    const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
    return new THREE.Vector3(Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e));
  }

  /** From the front of an open surface, else from where two sides and the top are seen. */
  function home() {
    const angles = (asked.get('view') || '').split(',').map(Number);
    if (asked.has('view') && angles.length === 2 && angles.every(isFinite)) return direction(...angles);
    const front = new THREE.Vector3(...facts.front);
    return front.length() > 0.5 ? front : direction(30, 20);
  }

  // ---- The side ----

  function hidden(mark) { return (asked.get('hide') || '').split(',').includes(mark); }

  function addMark(name, text, colour, count, show, off) {
    if (count === 0) return;
    const label = make('label', undefined, $('marks')), box = make('input', undefined, label);
    box.type = 'checkbox';
    box.id = 'mark_' + name;
    box.checked = !off && !hidden(name) || (asked.get('show') || '').split(',').includes(name);
    const key = make('span', undefined, label);
    key.className = 'key';
    key.style.background = css(colour);
    make('span', text + (count > 0 ? ': ' + count : ''), label);
    box.onchange = () => { show(box.checked); drawn = false; };
    box.onchange();
  }

  function addLines(name, text, colour, pairs, width) {
    const lines = makeLines(pairs, colour, width);
    if (lines) scene.add(lines);
    addMark(name, text, colour, pairs.length / 2, (on) => { lines.visible = on; });
  }

  /** The outlines of faces that meet others, through whatever hides them. */
  function meetingEdges(marked) {
    const pairs = [];
    for (const face of marked)
      for (let k = 0; k < 3; ++k) pairs.push(faces[3 * face + k], faces[3 * face + (k + 1) % 3]);
    return pairs;
  }

  function addMarks(points) {
    addMark('backs', 'backs of faces', BACK, -1, (on) => { uniforms.backs.value = on; });
    addLines('boundary', 'edges with one face', HOLE, numbers('boundary', Uint32Array), 3);
    addLines('surplus', 'edges with more than two faces', SURPLUS, numbers('surplus', Uint32Array), 3);
    const marked = new Set();
    const marks = scene.children[0].geometry.getAttribute('mark').array;
    for (let c = 0; c < faces.length; c += 3) if (marks[4 * c + 2]) marked.add(c / 3);
    const lines = makeLines(meetingEdges(marked), MEETING, 1.5, true);
    if (lines) scene.add(lines);
    addMark('meeting', 'faces that meet others', MEETING, marked.size,
            (on) => { uniforms.meetings.value = on; lines.visible = on; });
    addMark('edges', 'edges', [0.35, 0.38, 0.42], -1, (on) => { uniforms.edges.value = on; }, true);
    if (points)
      addMark('points', 'points' + (facts.every > 1 ? ', one in ' + facts.every : ''), POINT, -1,
              (on) => { points.visible = on; }, true);
  }

  function showHistogram(painting) {
    $('histogram').textContent = '';
    if (!painting) return;
    const NS = 'http://www.w3.org/2000/svg', svg = document.createElementNS(NS, 'svg');
    svg.setAttribute('viewBox', '0 0 300 110');
    svg.setAttribute('preserveAspectRatio', 'none');
    const add = (tag, attributes, text) => {
      const element = document.createElementNS(NS, tag);
      for (const name in attributes) element.setAttribute(name, attributes[name]);
      if (text) element.textContent = text;
      svg.appendChild(element);
    };
    const bins = painting.bins, most = Math.max(1, ...bins), width = 300 / bins.length;
    bins.forEach((count, i) => {
      const place = (i + 0.5) / bins.length * 4, stop = Math.min(Math.floor(place), 3);
      const colour = SCALE[stop].map((c, k) => c + (place - stop) * (SCALE[stop + 1][k] - c));
      const height = count ? Math.max(1, 80 * count / most) : 0;
      add('rect', { x: i * width, y: 82 - height, width: width, height: height, fill: css(colour), stroke: '#999', 'stroke-width': 0.3 });
      add('rect', { x: i * width, y: 84, width: width + 0.5, height: 8, fill: css(colour) });
    });
    add('text', { x: 0, y: 106, 'font-size': 12 }, '0');
    add('text', { x: 300, y: 106, 'font-size': 12, 'text-anchor': 'end' }, short(painting.length));
    $('histogram').appendChild(svg);
    make('div', 'mean ' + short(painting.mean) + ', largest ' + short(painting.largest) +
         (painting.beyond ? ', ' + painting.beyond + ' beyond the scale' : ''), $('histogram'));
  }

  const COLOURS = { plain: 0, truth_distances: 1, cloud_distances: 2, point_distances: 3 };

  function choose(name, points) {
    uniforms.source.value = COLOURS[name];
    showHistogram(facts[name]);
    const box = $('mark_points');
    if (box && name === 'point_distances' && !box.checked) { box.checked = true; box.onchange(); }
    drawn = false;
  }

  function addColours(points) {
    const first = facts[asked.get('colours')] ? asked.get('colours') : 'plain';
    for (const name in COLOURS) {
      if (name !== 'plain' && !facts[name]) continue;
      const label = make('label', undefined, $('colours')), button = make('input', undefined, label);
      button.type = 'radio';
      button.name = 'colours';
      button.id = 'colours_' + name;
      button.checked = name === first;
      make('span', name === 'plain' ? 'plain' : 'distance ' + facts[name].title, label);
      button.onchange = () => choose(name, points);
    }
    choose(first, points);
  }

  /** Is a face in the way from a place? */
  function isHidden(place, direction) {
    const ray = new THREE.Ray(place, direction), corners = [0, 1, 2].map(() => new THREE.Vector3());
    const hit = new THREE.Vector3();
    for (let f = 0; f < faces.length; f += 3) {
      corners.forEach((corner, k) => corner.fromArray(positions, 3 * faces[f + k]));
      if (ray.intersectTriangle(...corners, false, hit)) return true;
    }
    return false;
  }

  /** Where to look at a hole from: the front of a scan, else outside, also where the mesh is inside out. */
  function sideOf(hole, centre) {
    const out = new THREE.Vector3(...hole.normal), front = new THREE.Vector3(...facts.front);
    if (out.length() < 0.5) return home();
    const back = out.clone().negate();
    if (front.length() > 0.5) return out.dot(front) < 0 ? back : out;
    return isHidden(centre, out) && !isHidden(centre, back) ? back : out;
  }

  function flyToHole(index, at_once) {
    const hole = facts.holes[index];
    if (!hole) return;
    const centre = new THREE.Vector3(...hole.centre);
    // A hole fills a third of the view.
    fly(centre, sideOf(hole, centre), Math.max(1, 0.6 / Math.max(hole.diameter / facts.side, 1e-6)), at_once);
    [...$('holes').querySelectorAll('tr')].forEach((row, i) => row.classList.toggle('at', i === index + 1));
  }

  function addHoles() {
    if (!facts.hole_count) return;
    $('holes_part').hidden = false;
    $('holes_title').textContent = 'Holes and rims: ' + facts.hole_count +
        (facts.hole_count > facts.holes.length ? ', the widest ' + facts.holes.length + ' listed' : '');
    const table = make('table', undefined, $('holes')), head = make('tr', undefined, table);
    for (const name of ['diameter', 'length', 'area', 'edges']) make('td', name, head);
    facts.holes.forEach((hole, i) => {
      const row = make('tr', undefined, table);
      row.tabIndex = 0;
      for (const value of [hole.diameter, hole.length, hole.area]) make('td', short(value), row);
      make('td', hole.edges, row);
      row.onclick = () => flyToHole(i, false);
      row.onkeydown = (event) => { if (event.key === 'Enter') flyToHole(i, false); };
    });
  }

  function addViews() {
    const views = [['whole', home()]];
    ['x', 'y', 'z'].forEach((axis, k) => [1, -1].forEach((sign) => {
      const out = new THREE.Vector3();
      out.setComponent(k, sign);
      views.push([(sign > 0 ? '+' : '\u2212') + axis, out]);
    }));
    for (const [name, out] of views)
      make('button', name, $('views')).onclick = () => fly(new THREE.Vector3(), out, 1, false);
  }

  function fail(text) {
    $('failure').hidden = false;
    $('failure').textContent = text;
  }

  try {
    renderer = new THREE.WebGLRenderer({ antialias: true });
  } catch (error) {
    fail('This browser has no WebGL, so only the report is shown.');
    return;
  }
  renderer.setClearColor(0xffffff);
  $('view').appendChild(renderer.domElement);
  camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 2 * AWAY);
  controls = new THREE.TrackballControls(camera, renderer.domElement);
  controls.staticMoving = true;
  controls.rotateSpeed = 3;
  controls.addEventListener('change', () => { drawn = false; });
  controls.addEventListener('start', () => { flight = null; });
  scene.add(makeSurface());
  const points = makePoints();
  if (points) scene.add(points);
  addMarks(points);
  addColours(points);
  addHoles();
  addViews();
  window.addEventListener('resize', resize);
  resize();
  fly(new THREE.Vector3(), home(), 1, true);
  if (asked.has('hole')) flyToHole(Number(asked.get('hole')) - 1, true);
  if (!faces.length) fail(points ? '' : 'The mesh has no faces.');
  requestAnimationFrame(step);
}());
