/* The header record of a log: the library that wrote it, the host's note, and the configuration of
 * the scene. */
#include <string.h>

#include "base/error.h"
#include "base/memory.h"
#include "record/record.h"

#define CONFIG VBSS_CODE('C', 'O', 'N', 'F')

/* ---- the configuration of the scene */

_Static_assert(sizeof(vbss_scene_config) == 192, "new fields must be listed, with a new version");

typedef enum config_field_type { FIELD_U32, FIELD_F64 } config_field_type;
typedef struct config_field {
    const char *name;
    size_t offset;
    config_field_type type;
    uint32_t count;
    bool is_capacity; /* only sizes memory: may differ in a replay */
} config_field;

#define WORD(name)                                                    \
    {                                                                 \
#name, offsetof(vbss_scene_config, name), FIELD_U32, 1, false \
    }
#define ROOM(name)                                                   \
    {                                                                \
#name, offsetof(vbss_scene_config, name), FIELD_U32, 1, true \
    }
#define NUMBER(name)                                                  \
    {                                                                 \
#name, offsetof(vbss_scene_config, name), FIELD_F64, 1, false \
    }

/* The index in the table is the tag, so new fields are appended. */
static const config_field fields[] = {
    WORD(method),
    WORD(mode),
    ROOM(thread_capacity),
    ROOM(node_capacity),
    ROOM(rigid_capacity),
    ROOM(capsule_capacity),
    WORD(pin_capacity), /* part of the state */
    ROOM(contact_capacity),
    ROOM(candidate_capacity),
    ROOM(event_capacity),
    WORD(floor),
    {"floor_normal", offsetof(vbss_scene_config, floor_normal), FIELD_F64, 3, false},
    NUMBER(floor_height),
    NUMBER(floor_friction),
    NUMBER(thread_friction),
    NUMBER(contact_stiffness),
    NUMBER(contact_margin),
    NUMBER(stretch_tolerance),
    NUMBER(penetration_tolerance),
    WORD(iteration_limit),
    WORD(active_set_limit),
    WORD(halving_limit),
    WORD(attempt_limit),
    WORD(paper_pass_limit),
    NUMBER(paper_thickness),
    WORD(grasp_capacity), /* since version 2 */
    WORD(step_budget),    /* since version 3 */
    ROOM(drain_capacity), /* since version 4 */
    WORD(hole_capacity),
    WORD(call_budget),     /* since version 5 */
    NUMBER(speed_limit),   /* since version 6 */
    ROOM(matrix_capacity), /* since version 7 */
};
/* Of version 1, whose scenes had no graspers, 2, whose work had no limit, 3, which had no drains and
 * holes, 4, whose calls had no limit, 5, whose targets had no limit of speed, and 6, whose systems
 * had no configured capacity. */
enum {
    FIELDS = sizeof fields / sizeof fields[0],
    FIELDS_1 = 25,
    FIELDS_2 = 26,
    FIELDS_3 = 27,
    FIELDS_4 = 29,
    FIELDS_5 = 30,
    FIELDS_6 = 31,
    GRASPS_1 = 8,
    DRAINS_3 = 1,
    HOLES_3 = 16
};

static uint32_t field_count(uint32_t version)
{
    static const uint32_t before[] = {FIELDS_1, FIELDS_1, FIELDS_2, FIELDS_3,
                                      FIELDS_4, FIELDS_5, FIELDS_6};
    return version < 7 ? before[version] : FIELDS;
}

static void visit_scene_config(vbss_stream *stream, vbss_scene_config *config)
{
    vbss_section outer = vbss_stream_open(stream, CONFIG, 7);
    uint32_t count = field_count(stream->version);
    config->grasp_capacity = stream->version >= 2 ? config->grasp_capacity : GRASPS_1;
    config->step_budget = stream->version >= 3 ? config->step_budget : 0;
    config->drain_capacity = stream->version >= 4 ? config->drain_capacity : DRAINS_3;
    config->hole_capacity = stream->version >= 4 ? config->hole_capacity : HOLES_3;
    config->call_budget = stream->version >= 5 ? config->call_budget : 0;
    config->speed_limit = stream->version >= 6 ? config->speed_limit : 0.0;
    config->matrix_capacity = stream->version >= 7 ? config->matrix_capacity : 0;
    for (uint32_t i = 0; i < count; i++) {
        uint16_t tag = (uint16_t)i;
        void *value = (char *)config + fields[i].offset;
        if (fields[i].type == FIELD_U32) {
            vbss_stream_u32(stream, tag, value, fields[i].count);
        } else {
            vbss_stream_f64(stream, tag, value, fields[i].count);
        }
    }
    vbss_stream_close(stream, outer);
}

vbss_result vbss_log_compare_config(const log_header *header, const scene_info *scene)
{
    for (size_t i = 0; i < FIELDS; i++) {
        const char *wanted = (const char *)&header->scene + fields[i].offset;
        const char *found = (const char *)scene->config + fields[i].offset;
        size_t size = fields[i].type == FIELD_U32 ? sizeof(uint32_t) : sizeof(double);
        if (!fields[i].is_capacity && memcmp(wanted, found, size * fields[i].count) != 0) {
            return vbss_fail(scene->context, VBSS_ERROR_CORRUPT,
                             "the scene's %s is not that of the log", fields[i].name);
        }
    }
    return VBSS_OK;
}

/* ---- blobs */

vbss_result vbss_log_make_blob(vbss_context *context, log_blob *blob, const void *bytes,
                               size_t count)
{
    blob->bytes = vbss_allocate(context, count + 1, 1, "part of a log");
    if (blob->bytes == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    blob->count = (uint32_t)count;
    if (count > 0 && bytes != NULL) {
        memcpy(blob->bytes, bytes, count);
    }
    return VBSS_OK;
}

static void free_blob(vbss_context *context, log_blob *blob)
{
    vbss_release(context, blob->bytes, (size_t)blob->count + 1, 1);
    *blob = (log_blob){0};
}

static void visit_blob(vbss_stream *stream, uint16_t tag, vbss_context *context, log_blob *blob)
{
    uint32_t count = blob->count, max_count = UINT32_MAX;
    bool reading = stream->mode == VBSS_STREAM_READ;
    if (reading && stream->capacity - stream->position < max_count) {
        max_count = (uint32_t)(stream->capacity - stream->position);
    }
    vbss_stream_count(stream, tag, &count, max_count);
    if (reading && stream->result == VBSS_OK &&
        vbss_log_make_blob(context, blob, NULL, count) != VBSS_OK) {
        vbss_stream_refuse(stream, VBSS_ERROR_OUT_OF_MEMORY, "no memory for a part of the log");
    }
    vbss_stream_u8(stream, (uint16_t)(tag + 1), blob->bytes, count);
}

/* ---- header record */

void vbss_log_visit_header(vbss_stream *stream, log_header *header)
{
    vbss_section outer = vbss_stream_open(stream, LOG_HEADER, 1);
    vbss_stream_u32(stream, 1, &header->library_version, 1);
    visit_blob(stream, 2, header->context, &header->build_info);
    vbss_stream_u32(stream, 4, &header->hash_interval, 1);
    if (header->hash_interval == 0) {
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no such interval");
    }
    vbss_stream_count(stream, 5, &header->input_capacity, 65536);
    visit_blob(stream, 6, header->context, &header->note);
    visit_scene_config(stream, &header->scene);
    if (header->scene.event_capacity > 65536) { /* a reader allocates room for them */
        vbss_stream_refuse(stream, VBSS_ERROR_CORRUPT, "no scene keeps so many events");
    }
    vbss_stream_close(stream, outer);
}

void vbss_log_free_header(log_header *header)
{
    free_blob(header->context, &header->build_info);
    free_blob(header->context, &header->note);
}
