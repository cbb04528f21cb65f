/* Edits of a scene: a suspended step ends before an edit, and a refused edit changes nothing.
 *
 * The end of a step may cut threads, close holes and change meshes, so an edit that was valid before
 * it may be refused after it. The edit then takes the scene back to the suspended step. */
#include "base/error.h"
#include "base/memory.h"
#include "base/stream.h"
#include "scene/api/api.h"
#include "scene/snapshot/snapshot.h"
#include "scene/step/step.h"

/* Visits the state with everything that a refused call must leave as it was. */
static void visit(vbss_stream *stream, scene_object *s)
{
    stream->trusted = true;
    vbss_section outer = vbss_stream_open(stream, vbss_scene_kind.code, vbss_scene_kind.version);
    vbss_scene_serialise(stream, s);
    vbss_stream_close(stream, outer);
}

static vbss_result back_up(scene_object *s, scene_edit *edit)
{
    vbss_stream stream;
    vbss_stream_begin_measure(&stream);
    visit(&stream, s);
    edit->count = stream.position;
    edit->backup = vbss_allocate(s->context, edit->count, 1, "way back of an edit");
    if (edit->backup == NULL) {
        return VBSS_ERROR_OUT_OF_MEMORY;
    }
    vbss_stream_begin_write(&stream, edit->backup, edit->count);
    visit(&stream, s);
    return stream.result;
}

vbss_result vbss_scene_begin_edit(vbss_scene *scene, vbss_edit *input, scene_edit *edit)
{
    scene_object *s = ((vbss_slot *)scene)->object;
    *edit = (scene_edit){.scene = scene, .input = input};
    VBSS_TRY(vbss_edit_begin(scene, input));
    if (!s->cursor.is_suspended) {
        return VBSS_OK;
    }
    vbss_result result = back_up(s, edit);
    if (result == VBSS_OK) {
        result = vbss_scene_abandon_suspended_step(s);
    }
    return result == VBSS_OK ? VBSS_OK : vbss_scene_end_edit(edit, result);
}

vbss_result vbss_scene_end_edit(scene_edit *edit, vbss_result result)
{
    scene_object *s = ((vbss_slot *)edit->scene)->object;
    if (edit->backup != NULL) {
        if (result != VBSS_OK) {
            vbss_stream stream;
            vbss_stream_begin_read(&stream, edit->backup, edit->count);
            visit(&stream, s);
        }
        vbss_release(s->context, edit->backup, edit->count, 1);
    }
    return vbss_edit_end(edit->scene, edit->input, result);
}
