/**
 * @file vblast_ss.h
 * @brief All public headers of libvblast_ss.
 *
 * SPDX-License-Identifier: Apache-2.0
 */
#ifndef VBLAST_SS_VBLAST_SS_H
#define VBLAST_SS_VBLAST_SS_H

#include <vblast_ss/adapter.h>
#include <vblast_ss/base.h>
#include <vblast_ss/baseline.h>
#include <vblast_ss/collision.h>
#include <vblast_ss/core_speed.h>
#include <vblast_ss/device.h>
#include <vblast_ss/drain.h>
#include <vblast_ss/elementary.h>
#include <vblast_ss/grasper.h>
#include <vblast_ss/haptics.h>
#include <vblast_ss/knot.h>
#include <vblast_ss/mapping.h>
#include <vblast_ss/metrics.h>
#include <vblast_ss/mock.h>
#include <vblast_ss/needle.h>
#include <vblast_ss/output.h>
#include <vblast_ss/record.h>
#include <vblast_ss/replica.h>
#include <vblast_ss/scene.h>
#include <vblast_ss/scene_event.h>
#include <vblast_ss/scene_geometry.h>
#include <vblast_ss/scene_query.h>
#include <vblast_ss/scene_settings.h>
#include <vblast_ss/scene_surface.h>
#include <vblast_ss/session.h>
#include <vblast_ss/session_assistance.h>
#include <vblast_ss/session_coaching.h>
#include <vblast_ss/session_exercise.h>
#include <vblast_ss/solver_options.h>
#include <vblast_ss/thread.h>
#include <vblast_ss/visual.h>

#endif
