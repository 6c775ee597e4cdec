in vec3 way;
uniform vec3 skyLight;  // irradiance of the whole sky: how bright it looks on average
uniform float starry;   // how bright the stars are
out vec4 shownColour;

float hash(vec3 p) {
  p = fract(p * vec3(0.1031, 0.1030, 0.0973));
  p += dot(p, p.yxz + 33.33);
  return fract((p.x + p.y) * p.z);
}

// Stars in cells of a sphere's grid, of many brightnesses; the milky way as a band of more of them.
float stars(vec3 w) {
  vec3 at = w * 130.0, cell = floor(at);
  float kind = hash(cell), band = exp(-14.0 * pow(dot(w, normalize(vec3(0.5, 0.35, -0.8))), 2.0));
  vec3 off = vec3(hash(cell + 7.0), hash(cell + 13.0), hash(cell + 29.0)) * 0.6 + 0.2;
  float near = length(at - cell - off), bright = smoothstep(0.93 - 0.08 * band, 1.0, kind);
  return bright * bright * smoothstep(0.26, 0.05, near) + 0.012 * band;
}

void main() {
  vec3 w = normalize(way);
  float up = max(w.y, 0.0), sun = max(dot(w, sunWay), 0.0);
  vec3 light = skyLight * daylight;
  vec3 rgb = light * mix(vec3(1.25, 1.2, 1.1), vec3(0.75, 0.85, 1.0), smoothstep(0.0, 0.6, up));  // taste
  rgb += sunLight * daylight * (0.12 * pow(sun, 8.0) + 0.5 * pow(sun, 400.0));
  rgb += starry * stars(w) * vec3(0.95, 0.97, 1.0) * smoothstep(-0.02, 0.12, w.y) / max(exposure.g, 1e-3);
  if (w.y < 0.0) rgb = mix(rgb, light * vec3(0.55, 0.52, 0.5), smoothstep(0.0, -0.05, w.y));
  shownColour = vec4(toned(rgb), 1.0);
}
