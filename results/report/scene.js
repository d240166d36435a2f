// The 3D view of one room.

import {
  AmbientLight, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshLambertMaterial, PerspectiveCamera, Points, PointsMaterial, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {onThemeChange, theme} from './page.js';

const RIGHT = new Color('#0072b2');
const WRONG = new Color('#d55e00');
const SILENT = new Color('#adb5bd');

export const MODES = [['prediction', 'Prediction'], ['truth', 'Truth'], ['error', 'Error'], ['planes', 'Planes']];
const PALETTE = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#f0e442'].map((c) => new Color(c));

function meshOf(surface, color) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(surface.vertices, (v) => v / 1000), 3));
  geometry.setIndex(surface.triangles);
  geometry.computeVertexNormals();
  const mesh = new Mesh(geometry, new MeshLambertMaterial({color, side: DoubleSide, transparent: true, opacity: 0.75, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1}));
  const ends = [];
  let base = 0;
  for (const count of surface.rings) {
    for (let i = 0; i < count; ++i) {
      for (const k of [base + i, base + (i + 1) % count]) ends.push(...surface.vertices.slice(3 * k, 3 * k + 3).map((v) => v / 1000));
    }
    base += count;
  }
  const outline = new BufferGeometry();
  outline.setAttribute('position', new BufferAttribute(new Float32Array(ends), 3));
  mesh.add(new LineSegments(outline, new LineBasicMaterial({color: color.clone().multiplyScalar(0.55)})));
  return mesh;
}

function boxOf(entity, color) {
  const axes = [0, 1, 2].map((c) => new Vector3(...entity.axes.slice(3 * c, 3 * c + 3)).multiplyScalar(entity.size[c] / 2000));
  const center = new Vector3(...entity.box).divideScalar(1000);
  const corner = (i) => axes.reduce((p, a, c) => p.addScaledVector(a, i & (1 << c) ? 1 : -1), center.clone());
  const ends = [];
  for (let i = 0; i < 8; ++i) for (const bit of [1, 2, 4]) if (!(i & bit)) ends.push(...corner(i).toArray(), ...corner(i | bit).toArray());
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(ends), 3));
  return new LineSegments(geometry, new LineBasicMaterial({color}));
}

export class SceneView {
  /** `onSelect(entityId or null)` when a surface was clicked. */
  constructor(holder, data, run, onSelect) {
    this.data = data;
    this.run = run;
    this.onSelect = onSelect;
    this.classColors = run.classes.map(([, color]) => new Color(color));
    this.entityOf = new Map(data.entities.map((e) => [e.id, e]));
    this.renderer = new WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.canvas = this.renderer.domElement;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('aria-label', `3D view of ${data.name}; arrow keys turn, plus and minus zoom`);
    holder.append(this.canvas);
    this.scene = new Scene();
    this.scene.add(new AmbientLight(0xffffff, 2.0));
    this.sun = new DirectionalLight(0xffffff, 1.6);
    this.camera = new PerspectiveCamera(40, 1, 0.05, 500);
    this.camera.up.set(0, 0, 1);
    this.camera.add(this.sun);
    this.sun.position.set(-1, 1.5, 1);
    this.scene.add(this.camera);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener('change', () => {
      this.openTowardsEye();
      this.draw();
    });
    this.addContents();
    this.frame();
    this.observer = new ResizeObserver(() => this.resize(holder));
    this.observer.observe(holder);
    this.resize(holder);
    this.listen();
    this.setMode('prediction');
    onThemeChange(() => this.draw());
  }

  addContents() {
    const {data} = this;
    const positions = Float32Array.from(data.points, (v) => v / 1000);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(positions.length), 3));
    this.points = new Points(geometry, new PointsMaterial({size: 0.022, vertexColors: true}));
    this.scene.add(this.points);
    this.surfaces = new Group();
    for (const surface of data.surfaces) {
      if (surface.triangles.length === 0) continue;
      const mesh = meshOf(surface, this.entityColor(surface.entity));
      mesh.userData = surface;
      this.surfaces.add(mesh);
    }
    this.scene.add(this.surfaces);
    this.boxes = new Group();
    for (const entity of data.entities) {
      if ((entity.members ?? []).length > 1 && entity.class > 0) this.boxes.add(boxOf(entity, this.entityColor(entity.id)));
    }
    this.scene.add(this.boxes);
  }

  entityColor(id) {
    const entity = this.entityOf.get(id);
    return entity && entity.class > 0 ? this.classColors[entity.class] : SILENT;
  }

  frame() {
    this.points.geometry.computeBoundingBox();
    const box = this.points.geometry.boundingBox;
    for (const mesh of this.surfaces.children) box.expandByObject(mesh);
    const center = box.isEmpty() ? new Vector3() : box.getCenter(new Vector3());
    const size = box.isEmpty() ? 2 : box.getSize(new Vector3()).length();
    this.controls.target.copy(center);
    this.camera.position.copy(center).add(new Vector3(-0.35, -0.62, 0.72).multiplyScalar(size));
    this.controls.update();
  }

  setMode(mode) {
    this.mode = mode;
    const {data} = this;
    const colors = this.points.geometry.attributes.color;
    const truth = data.truth;
    for (let i = 0; i < colors.count; ++i) {
      let color = this.classColors[data.said[i]] ?? SILENT;
      if (data.said[i] === 0) color = SILENT;
      if (mode === 'truth') color = truth ? this.classColors[truth[i]] ?? SILENT : SILENT;
      if (mode === 'error') color = !truth || truth[i] <= 0 || data.said[i] === 0 ? SILENT : truth[i] === data.said[i] ? RIGHT : WRONG;
      if (mode === 'planes') color = data.plane[i] < 0 ? SILENT : PALETTE[data.plane[i] % PALETTE.length];
      colors.setXYZ(i, color.r, color.g, color.b);
    }
    colors.needsUpdate = true;
    this.applyFaces();
  }

  /** Large surfaces seen from behind (near walls, the ceiling) are left out with their points, so that one sees into the room. */
  openTowardsEye() {
    const hidden = new Set();
    const center = new Vector3();
    for (const mesh of this.surfaces.children) {
      const {id, area, normal, vertices} = mesh.userData;
      if (!(area >= 2)) continue;
      center.set(vertices[0], vertices[1], vertices[2]).divideScalar(1000);
      const away = new Vector3(...normal).dot(center.sub(this.camera.position)) > 0;
      if (away) hidden.add(id);
      mesh.visible = !away;
    }
    const key = [...hidden].join();
    if (key === this.hiddenKey) return;
    this.hiddenKey = key;
    const index = [];
    this.data.plane.forEach((plane, i) => { if (!hidden.has(plane)) index.push(i); });
    this.points.geometry.setIndex(index);
  }

  applyFaces() {
    this.openTowardsEye();
    const shown = this.mode === 'prediction';
    const chosen = this.entityOf.get(this.selected);
    const parts = new Set(chosen ? chosen.surfaces : []);
    for (const mesh of this.surfaces.children) {
      const strong = parts.has(mesh.userData.id);
      mesh.material.visible = shown || strong;
      mesh.children[0].material.visible = shown || strong;
      mesh.material.opacity = strong ? 0.95 : this.selected !== undefined && this.selected !== null ? 0.35 : 0.75;
      mesh.material.emissive.set(strong ? 0x333300 : 0x000000);
    }
    this.boxes.visible = shown;
    this.draw();
  }

  select(id) {
    this.selected = id;
    this.applyFaces();
  }

  pick(event) {
    const box = this.canvas.getBoundingClientRect();
    const at = new Vector2(2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height);
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    const hits = ray.intersectObjects(this.surfaces.children.filter((mesh) => mesh.visible), false);
    // The nearest thing that has a name goes before the nearest surface: rooms have walls in front.
    const named = hits.find((h) => (this.entityOf.get(h.object.userData.entity)?.class ?? 0) > 3);
    const hit = named ?? hits[0];
    this.onSelect(hit ? hit.object.userData.entity : null);
  }

  listen() {
    let down = null;
    this.canvas.addEventListener('pointerdown', (e) => { down = [e.clientX, e.clientY]; });
    this.canvas.addEventListener('pointerup', (e) => {
      if (down && Math.hypot(e.clientX - down[0], e.clientY - down[1]) < 4) this.pick(e);
      down = null;
    });
    this.canvas.addEventListener('keydown', (e) => {
      const turns = {ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, -0.08], ArrowDown: [0, 0.08]};
      if (turns[e.key]) this.turn(...turns[e.key]);
      else if (e.key === '+' || e.key === '=') this.zoom(0.9);
      else if (e.key === '-') this.zoom(1.1);
      else if (e.key === '0') this.frame();
      else return;
      e.preventDefault();
    });
  }

  turn(azimuth, polar) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    const radius = arm.length();
    const theta = Math.atan2(arm.y, arm.x) + azimuth;
    const phi = Math.min(Math.PI - 0.05, Math.max(0.05, Math.acos(arm.z / radius) + polar));
    this.camera.position.copy(this.controls.target).add(new Vector3(
      radius * Math.sin(phi) * Math.cos(theta), radius * Math.sin(phi) * Math.sin(theta), radius * Math.cos(phi)));
    this.controls.update();
  }

  zoom(factor) {
    const arm = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
  }

  resize(holder) {
    const width = Math.max(200, holder.clientWidth);
    const height = Math.max(260, holder.clientHeight);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    this.renderer.setClearColor(theme('--stage') || '#ffffff');
    this.renderer.render(this.scene, this.camera);
  }

  dispose() {
    this.observer.disconnect();
    this.controls.dispose();
    this.scene.traverse((node) => {
      node.geometry?.dispose();
      node.material?.dispose?.();
    });
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }
}
