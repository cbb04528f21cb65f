/* What the player gets of a session: at even times the places of all that was seen, without the vertices. What is rigid is a
 * mesh once and a pose a frame; a thread its middle line; a drain its surface, undivided. */
#ifndef VBSS_EXAMPLES_REPLAY_PAGE_FILM_H
#define VBSS_EXAMPLES_REPLAY_PAGE_FILM_H

#include <stdbool.h>

#include "report/text.h"

#include <vblast_ss/visual.h>

/* Whole numbers of the film: places in so many m, parts of a unit quaternion. 16 bits of them reach 0.33 m. */
#define FILM_PLACE 1e-5
#define FILM_TURN (1.0 / 32767.0)

/* A row of VBSS_VISUAL_VIEW_VERTICES. */
typedef struct film_vertex {
    float position[3], normal[3], texture[2], material[3], value;
} film_vertex;

/* A row of VBSS_VISUAL_VIEW_SPOTS, with the body in the place of the part. */
typedef struct film_decal {
    float body, kind, material[3], radius;
} film_decal;

typedef enum film_form { FILM_RIGID, FILM_TUBE, FILM_SURFACE } film_form;

/* Of one body, or of a part of it that is rigid. */
typedef struct film_model {
    film_form form;
    uint32_t kind, body, piece; /* vbss_visual_kind; number in the scene; among those of the body */
    double radius;              /* of a tube, m */
    uint32_t vertex_count, triangle_count;
    film_vertex *vertices; /* as the visual gave them when it was first seen, but about `middle` */
    uint32_t (*triangles)[3];
    double middle[3];
    uint32_t corners[3]; /* vertices by which its pose is found: far from each other */
} film_model;

/* A body in a frame: which model, and of how many places it consists. */
typedef struct film_item {
    uint32_t model, count;
} film_item;

enum { FILM_MODELS = 256, FILM_ITEMS = 64 };

typedef struct film_layout {
    film_item items[FILM_ITEMS];
    uint32_t count;
} film_layout;

/* Spots of a drain from a frame on. */
typedef struct film_decals {
    uint32_t frame, count;
    film_decal *rows;
} film_decals;

typedef struct film {
    film_model models[FILM_MODELS];
    uint32_t model_count;
    film_layout *layouts;
    size_t layout_count, layout_room;
    film_decals *decals;
    size_t decal_count, decal_room;
    uint32_t frames;
    uint8_t *bytes; /* the frames, as film_code.c writes them */
    size_t byte_count, byte_room;
    int32_t *now, *before; /* numbers of a frame */
    size_t now_count, now_room, before_count, before_room;
    uint32_t layout, layout_before;
    bool beyond; /* something was too far away for 16 bits, and is shown at their edge */
} film;

/* Adds what the visual shows as another frame; false: no memory, or more bodies than there is room for. */
bool film_add(film *f, vbss_visual *visual);
void film_free(film *f);

/* ---- film_code.c */
/* The frame in `now` behind those before, as differences to the last one, or where that had other bodies from place to place. */
bool film_code(film *f);
/* Its tables as JSON, its numbers as base64: what player/film.js reads. */
void film_put(page *p, const film *f);

/* ---- film_pose.c */
/* Of a model that is rigid, among vertices as the visual gives them: place of its middle, w, x, y, z. */
void film_pose(const film_model *m, const film_vertex *vertices, double place[3], double turn[4]);
/* Chooses the corners. */
void film_find_corners(film_model *m);

#endif
