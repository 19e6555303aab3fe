// Inputs of lab 10's functions that the kernels send for whole pictures: see judge_10.h, sent.h.
#include "judge_10.h"
#include "oracle3d.h"
#include "sent.h"

#include <math.h>

// ---- Tiles of rays ------------------------------------------------------------------------------

// Any tile of a scene: its rays, and between which directions they are.
typedef struct SentTile {
    OracleVector rays[TILE_RAYS];
    double low[3], high[3];
} SentTile;

static SentTile roll_tile(Random *random, const JobScene3D *scene)
{
    const int width = scene->scene.width, height = scene->scene.height;
    const int x = (int)random_integer(random, 0, (width - 1) / TILE_SIDE) * TILE_SIDE;
    const int y = (int)random_integer(random, 0, (height - 1) / TILE_SIDE) * TILE_SIDE;
    SentTile tile = {.low = {1, 1, 1}, .high = {-1, -1, -1}};
    for (int i = 0; i < TILE_RAYS; i++) {
        const int column = x + i % TILE_SIDE, row = y + i / TILE_SIDE;
        const int pixel =
            (row < height ? row : height - 1) * width + (column < width ? column : width - 1);
        tile.rays[i] = job_scene3d_ray(scene, pixel).direction;
        for (u32 axis = 0; axis < 3; axis++) {
            const double part = vector_component(tile.rays[i], axis);
            tile.low[axis] = fmin(tile.low[axis], part);
            tile.high[axis] = fmax(tile.high[axis], part);
        }
    }
    return tile;
}

// A plane of the scene's tree.
static void keep_plane(Random *random, const JobScene3D *scene, const SentTile *tile,
                       Sent planes[N_PLANE_RANGES_10])
{
    const KdTree3D *tree = &scene->tree;
    const KdNode3 node = tree->nodes[random_integer(random, 0, tree->n_nodes - 1)];
    const int is_leaf = node.split_axis == KD_LEAF;
    const u32 axis = is_leaf ? (u32)random_integer(random, 0, 2) : node.split_axis;
    const TilePlaneJob job = {
        is_leaf ? tree->bounds.min[axis] : node.split_pos,
        (float)vector_component(vector_of(scene->camera.eye), axis),
        (float)tile->low[axis],
        (float)tile->high[axis],
    };
    const enum PlaneRange10 range = job.eye == job.plane          ? TILES_ON_PLANE
                                    : job.low > 0 || job.high < 0 ? TILES_ONE_WAY
                                                                  : TILES_BOTH_WAYS;
    sent_keep(&planes[range], random, &job);
}

// A sphere of the scene, and the cone around the tile's rays.
static void keep_cone(Random *random, const JobScene3D *scene, const SentTile *tile, Sent cones[3])
{
    const Scene3D *s = &scene->scene;
    if (s->n_spheres == 0) {
        return;
    }
    const OracleVector axis = vector_unit((OracleVector){
        tile->low[0] + tile->high[0], tile->low[1] + tile->high[1], tile->low[2] + tile->high[2]});
    double sine = 0, cosine = 1;
    for (int i = 0; i < TILE_RAYS; i++) {
        const double along = vector_dot(tile->rays[i], axis);
        sine = fmax(sine, vector_length(vector_minus(tile->rays[i], vector_scaled(along, axis))));
        cosine = fmin(cosine, along);
    }
    if (cosine < 0x1p-4) {  // half of the view: for such the kernel has a cone of its own
        sine = 0, cosine = -1;
    }
    const Sphere sphere = s->spheres[random_integer(random, 0, s->n_spheres - 1)];
    const OracleVector centre =
        vector_minus((OracleVector){sphere.x, sphere.y, sphere.z}, vector_of(scene->camera.eye));
    const double along = vector_dot(centre, axis), size = fabs((double)sphere.radius);
    const double aside = vector_length(vector_minus(centre, vector_scaled(along, axis)));
    const double gap = aside * cosine - along * sine - size;
    const ConeJob job = {vector_rounded(axis), (float)cosine, (float)sine, vector_rounded(centre),
                         sphere.radius};
    sent_keep(&cones[along <= 0 || sine == 0 ? CONES_EDGES
                     : fabs(gap) > size / 8  ? CONES_CLEAR
                                             : CONES_HAIR],
              random, &job);
}

// ---- Rows of circles ----------------------------------------------------------------------------

// The calls for a row of tile i: each circle of its list is painted behind those before it.
static void keep_row(Random *random, const Job10 *job, int i, Sent rows[N_ROW_RANGES])
{
    const CircleTileJob tile = job->circle_tiles[i];
    const TileNode leaf = job->circle_nodes[tile.first_node + leaf_10_of_tile(job, i)];
    const TileCircle *circles = job->leaf_circles + tile.first_circle + leaf.first;
    const float y = (float)(tile.y + (int)random_integer(random, 0, ROW_PIXELS - 1));
    CircleRowJob row = {.dy = 0};
    for (int pixel = 0; pixel < ROW_PIXELS; pixel++) {
        row.open[pixel] = -1;
    }
    for (u32 k = 0; k < leaf.n_circles; k++) {
        int n_open = 0;
        row.dy = y - circles[k].y;
        row.radius_squared = circles[k].radius_squared;
        row.color = circles[k].color;
        for (int pixel = 0; pixel < ROW_PIXELS; pixel++) {
            const float dx = (float)(tile.x + pixel) - circles[k].x;
            row.dx_squared[pixel] = dx * dx;
            n_open += row.open[pixel] != 0;
        }
        if (!row_10_is_decided(&row)) {
            return;
        }
        sent_keep(&rows[n_open == ROW_PIXELS ? ROWS_OPEN : ROWS_PAINTED], random, &row);
        for (int pixel = 0; pixel < ROW_PIXELS; pixel++) {
            const double sum = (double)row.dx_squared[pixel] + (double)row.dy * (double)row.dy;
            if (row.open[pixel] && sum <= (double)row.radius_squared) {
                row.open[pixel] = 0;
                row.colors[pixel] = row.color;
            }
        }
    }
}

// ---- All ----------------------------------------------------------------------------------------

void add_sent_10(Random *random, Job10 *job)
{
    enum { N_TILES = 3000 };
    Sent planes[N_PLANE_RANGES_10], cones[3], rows[N_ROW_RANGES];
    for (int range = 0; range < 3; range++) {
        planes[range] = SENT_TO(job->planes + range * N_TILE_PLANE_INPUTS, N_SENT_PLANES);
        cones[range] = SENT_TO(job->cones + range * N_CONE_INPUTS, N_SENT_CONES);
    }
    for (int range = 0; range < N_ROW_RANGES; range++) {
        rows[range] = SENT_TO(job->rows + range * N_ROW_INPUTS, N_SENT_ROWS);
    }
    for (int i = 0; i < N_TILES; i++) {
        const JobScene3D *scene = &job->scenes[i % N_SCENES];
        const SentTile tile = roll_tile(random, scene);
        keep_plane(random, scene, &tile, planes);
        keep_cone(random, scene, &tile, cones);
        keep_row(random, job, i % N_CIRCLE_TILES, rows);
    }
}
