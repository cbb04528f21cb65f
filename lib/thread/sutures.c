/* Sutures by material and size. docs/reference/sutures.md has the sources. */
#include "base/api_call.h"
#include "base/error.h"
#include "base/pi.h"
#include "thread/thread.h"
#include "thread/tuning.h"

typedef struct suture_material {
    double density;         /* kg/m^3 */
    double modulus;         /* of elasticity, Pa */
    double bending_modulus; /* EI over the second moment of the section, Pa */
} suture_material;

static const suture_material materials[] = {
    {SUTURE_SILK_DENSITY, SUTURE_SILK_MODULUS, SUTURE_BRAID_BENDING_MODULUS},
    {SUTURE_POLYGLACTIN_DENSITY, SUTURE_POLYGLACTIN_MODULUS, SUTURE_BRAID_BENDING_MODULUS},
    {SUTURE_POLYPROPYLENE_DENSITY, SUTURE_POLYPROPYLENE_MODULUS, SUTURE_POLYPROPYLENE_MODULUS},
    {SUTURE_NYLON_DENSITY, SUTURE_NYLON_MODULUS, SUTURE_NYLON_MODULUS},
};

/* The middle of the range of the diameter by USP <861>, m; 0: no such size. There is no 1-0. */
static double diameter_of(vbss_thread_usp_size size)
{
    static const double diameters[] = {0.025e-3, 0.035e-3, 0.045e-3, 0.06e-3, 0.085e-3,
                                       0.125e-3, 0.175e-3, 0.225e-3, 0.32e-3, 0.0,
                                       0.375e-3, 0.45e-3,  0.55e-3};
    return size < VBSS_THREAD_USP_10_0 || size > VBSS_THREAD_USP_2
               ? 0.0
               : diameters[size - VBSS_THREAD_USP_10_0];
}

vbss_result vbss_thread_config_suture(vbss_thread_config *config, vbss_thread_material material,
                                      vbss_thread_usp_size size)
{
    VBSS_ENTER(NULL);
    VBSS_TRY(vbss_thread_check_config_size(config));
    double radius = 0.5 * diameter_of(size), area = VBSS_PI * radius * radius;
    if (radius == 0.0 || material < VBSS_THREAD_MATERIAL_SILK ||
        material > VBSS_THREAD_MATERIAL_NYLON) {
        return VBSS_ERROR_OUT_OF_RANGE;
    }
    const suture_material *m = &materials[material];
    config->radius = radius;
    config->linear_density = m->density * area;
    config->axial_stiffness = m->modulus * area;
    config->bending_stiffness = m->bending_modulus * 0.25 * area * radius * radius;
    return VBSS_OK;
}
