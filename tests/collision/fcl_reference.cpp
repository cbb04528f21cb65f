#include "collision/fcl_reference.h"

#include <algorithm>
#include <memory>
#include <new>
#include <vector>

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>
#include <fcl/narrowphase/distance.h>

namespace
{

typedef fcl::Vector3d point;

point at(const double *vertices, int index)
{
    return point(vertices[3 * index], vertices[3 * index + 1], vertices[3 * index + 2]);
}

/* FCL's capsules lie along z with their middle at the origin. */
struct placed_capsule {
    placed_capsule(const double *ends, double radius)
        : shape(radius, (at(ends, 1) - at(ends, 0)).norm()), pose(fcl::Transform3d::Identity())
    {
        pose.translation() = 0.5 * (at(ends, 0) + at(ends, 1));
        if (shape.lz > 0.0) {
            pose.linear() =
                fcl::Quaterniond::FromTwoVectors(point::UnitZ(), at(ends, 1) - at(ends, 0))
                    .toRotationMatrix();
        }
    }

    fcl::Capsuled shape;
    fcl::Transform3d pose;
};

} // namespace

double fcl_capsules_distance(const double a[6], double radius_a, const double b[6], double radius_b)
{
    const placed_capsule one(a, radius_a), other(b, radius_b);
    fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    fcl::distance(&one.shape, one.pose, &other.shape, other.pose, request, result);
    return result.min_distance;
}

double fcl_triangles_distance(const double a[9], const double b[9])
{
    point on_a, on_b;
    return fcl::detail::TriangleDistance<double>::triDistance(
        at(a, 0), at(a, 1), at(a, 2), at(b, 0), at(b, 1), at(b, 2), on_a, on_b);
}

bool fcl_features_meet(vbss_collision_pair_kind kind, const double start[12], const double end[12],
                       double *time)
{
    typedef fcl::detail::Intersectd intersect;
    const double *s = start, *e = end;
    point where;
    return kind == VBSS_COLLISION_PAIR_EDGE_EDGE
               ? intersect::intersect_EE(at(s, 0), at(s, 1), at(s, 2), at(s, 3), at(e, 0), at(e, 1),
                                         at(e, 2), at(e, 3), time, &where)
               : intersect::intersect_VF(at(s, 1), at(s, 2), at(s, 3), at(s, 0), at(e, 1), at(e, 2),
                                         at(e, 3), at(e, 0), time, &where);
}

bool fcl_shifted_capsules_meet(const double start[12], const double end[12], double radius_a,
                               double radius_b, unsigned instants, double *time)
{
    const placed_capsule a(start, radius_a), b(start + 6, radius_b);
    fcl::Transform3d a_end = a.pose, b_end = b.pose;
    a_end.translation() += at(end, 0) - at(start, 0);
    b_end.translation() += at(end, 2) - at(start, 2);
    /* Its instants are also limited by 1 / toc_err. */
    const fcl::ContinuousCollisionRequestd request(instants, 0.5 / instants, fcl::CCDM_TRANS,
                                                   fcl::GST_LIBCCD, fcl::CCDC_NAIVE);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(&a.shape, a.pose, a_end, &b.shape, b.pose, b_end, request, result);
    *time = result.time_of_contact;
    return result.is_collide;
}

/* ---- boxes */

struct fcl_boxes {
    explicit fcl_boxes(uint32_t count);

    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
    std::vector<std::shared_ptr<fcl::Boxd>> shapes;
    fcl::DynamicAABBTreeCollisionManagerd tree;
    bool planted;
};

/* An object that stands at the origin has its shape's box. */
fcl_boxes::fcl_boxes(uint32_t count) : planted(false)
{
    for (uint32_t i = 0; i < count; i++) {
        shapes.emplace_back(new fcl::Boxd(1.0, 1.0, 1.0));
        objects.emplace_back(new fcl::CollisionObjectd(shapes.back()));
        objects.back()->setUserData(reinterpret_cast<void *>(static_cast<uintptr_t>(i)));
    }
}

fcl_boxes *fcl_boxes_create(uint32_t count)
{
    try {
        return new fcl_boxes(count);
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
}

void fcl_boxes_destroy(fcl_boxes *boxes)
{
    delete boxes;
}

void fcl_boxes_set(fcl_boxes *boxes, uint32_t index, const double low[3], const double high[3])
{
    fcl::AABBd &box = boxes->shapes[index]->aabb_local;
    box.min_ = at(low, 0);
    box.max_ = at(high, 0);
    boxes->objects[index]->computeAABB();
}

namespace
{

struct listener {
    void (*report)(void *user, uint32_t i, uint32_t j);
    void *user;
};

uint32_t index_of(const fcl::CollisionObjectd *object)
{
    return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(object->getUserData()));
}

bool report_pair(fcl::CollisionObjectd *a, fcl::CollisionObjectd *b, void *user)
{
    const listener *to = static_cast<const listener *>(user);
    uint32_t i = index_of(a), j = index_of(b);
    to->report(to->user, std::min(i, j), std::max(i, j));
    return false; /* go on */
}

} // namespace

void fcl_boxes_find_pairs(fcl_boxes *boxes, void (*report)(void *user, uint32_t i, uint32_t j),
                          void *user)
{
    if (boxes->planted) {
        boxes->tree.update();
    } else {
        std::vector<fcl::CollisionObjectd *> all;
        for (const auto &object : boxes->objects) {
            all.push_back(object.get());
        }
        boxes->tree.registerObjects(all);
        boxes->tree.setup();
        boxes->planted = true;
    }
    listener to = {report, user};
    boxes->tree.collide(&to, report_pair);
}
