#include "scenes/hand_path.h"

#include "base/elementary.h"

static const double pi = 3.14159265358979323846;

hand_path hand_path_draw(vbss_random *random, double size)
{
    hand_path path;
    for (int k = 0; k < HAND_PATH_HARMONICS; k++) {
        path.sine[k] = vec3_scale(vbss_random_direction(random), size / (k + 1));
        path.cosine[k] = vec3_scale(vbss_random_direction(random), size / (k + 1));
    }
    return path;
}

vec3 hand_path_at(const hand_path *path, double time)
{
    vec3 x = vec3_zero();
    for (int k = 0; k < HAND_PATH_HARMONICS; k++) {
        double sine, cosine;
        vbss_sincos(2.0 * pi * (k + 1) * time, &sine, &cosine);
        x = vec3_add_scaled(x, sine, path->sine[k]);
        x = vec3_add_scaled(x, cosine - 1.0, path->cosine[k]);
    }
    return x;
}
