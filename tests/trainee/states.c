/* A try of the whole task that is begun, saved on its path, and continued from there. */
#include "trainee/trainee.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

vbss_result trainee_begin_task(trainee *t, uint64_t seed, const char *log)
{
    trainee_wake(t, seed);
    TRY(live_create(&t->live, live_find("stitch"), (unsigned long)seed, NULL, log));
    trainee_open_eyes(t);
    return VBSS_OK;
}

/* ---- saved */

typedef struct saved_head {
    uint64_t random, shades, steps, scene_bytes, session_bytes;
    uint32_t aids, helps; /* helps: 1, is_wound: 2, has_pulled: 4, is_crossed: 8, is_later: 16 */
    double home;
    vec entry, slit;
} saved_head;

static bool write_parts(FILE *file, const saved_head *head, const uint8_t *scene,
                        const uint8_t *session)
{
    return fwrite(head, sizeof *head, 1, file) == 1 &&
           fwrite(scene, 1, (size_t)head->scene_bytes, file) == head->scene_bytes &&
           fwrite(session, 1, (size_t)head->session_bytes, file) == head->session_bytes;
}

void trainee_save(trainee *t)
{
    char path[512];
    vbss_scene *scene = t->live.stage.rig->scene;
    vbss_session *session = t->live.stage.task.session;
    saved_head head;
    if (t->folder == NULL) {
        return;
    }
    memset(&head, 0, sizeof head);
    head.random = t->random;
    head.shades = t->shades;
    head.steps = t->live.steps;
    head.aids = t->live.aids;
    head.helps = (t->helps ? 1u : 0u) | (t->is_wound ? 2u : 0u) | (t->has_pulled ? 4u : 0u) |
                 (t->is_crossed ? 8u : 0u) | (t->is_later ? 16u : 0u);
    head.home = t->home;
    head.entry = t->entry;
    head.slit = t->slit;
    (void)vbss_scene_save(scene, NULL, 0, &head.scene_bytes); /* asks for the sizes */
    (void)vbss_session_save(session, NULL, 0, &head.session_bytes);
    uint8_t *a = malloc(head.scene_bytes), *b = malloc(head.session_bytes);
    if (a != NULL && b != NULL &&
        vbss_scene_save(scene, a, head.scene_bytes, &head.scene_bytes) == VBSS_OK &&
        vbss_session_save(session, b, head.session_bytes, &head.session_bytes) == VBSS_OK) {
        snprintf(path, sizeof path, "%s/%03d-%d.state", t->folder, (int)(t->live.time + 0.5),
                 (int)trainee_see(t)->coach.goal);
        FILE *file = fopen(path, "wb");
        bool good = file != NULL && write_parts(file, &head, a, b);
        if (file == NULL || fclose(file) != 0 || !good) {
            fprintf(stderr, "trainee: %s cannot be written\n", path);
        }
    }
    free(a);
    free(b);
}

/* ---- continued */

static vbss_result restore(trainee *t, FILE *file, uint8_t *bytes, const saved_head *head)
{
    stage *s = &t->live.stage;
    vbss_session_status status;
    size_t count = (size_t)(head->scene_bytes + head->session_bytes);
    if (fread(bytes, 1, count, file) != count) {
        return VBSS_ERROR_CORRUPT;
    }
    TRY(vbss_scene_restore(s->rig->scene, bytes, head->scene_bytes));
    TRY(vbss_session_restore(s->task.session, bytes + head->scene_bytes, head->session_bytes));
    for (int side = 0; side < SIDES; side++) {
        TRY(mouse_hand_create(&t->live.hands[side], s->context, s->graspers[side]));
        TRY(mouse_hand_read(&t->live.hands[side], 1e-3 * (double)head->steps));
    }
    t->random = head->random;
    t->shades = head->shades;
    t->live.steps = head->steps;
    t->live.time = 1e-3 * (double)head->steps;
    t->live.aids = head->aids;
    TRY(vbss_session_get_status(s->task.session, &status, sizeof status));
    t->live.aided = status.aids_used != 0;
    t->helps = (head->helps & 1u) != 0;
    t->is_wound = (head->helps & 2u) != 0;
    t->has_pulled = (head->helps & 4u) != 0;
    t->is_crossed = (head->helps & 8u) != 0;
    t->is_later = (head->helps & 16u) != 0;
    t->home = head->home;
    t->entry = head->entry;
    t->slit = head->slit;
    trainee_open_eyes(t);
    return VBSS_OK;
}

vbss_result trainee_resume(trainee *t, uint64_t seed, const char *path)
{
    saved_head head;
    vbss_result result = VBSS_ERROR_CORRUPT;
    TRY(trainee_begin_task(t, seed, NULL));
    FILE *file = fopen(path, "rb");
    if (file == NULL || fread(&head, sizeof head, 1, file) != 1) {
        return VBSS_ERROR_NOT_FOUND;
    }
    uint8_t *bytes = malloc((size_t)(head.scene_bytes + head.session_bytes));
    if (bytes != NULL) {
        result = restore(t, file, bytes, &head);
    }
    free(bytes);
    (void)fclose(file);
    return result;
}
