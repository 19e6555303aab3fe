// What a judge does with each of its job's scenes, whatever is in them: job_scene.h, job_scene3d.h
// and the labs have such kinds.
#ifndef JUDGE_SCENE_KIND_H
#define JUDGE_SCENE_KIND_H

#include <stddef.h>
#include <stdio.h>

typedef struct SceneKind {
    // Write scene number k as sections "scene.K" ... Returns 0, or -1.
    int (*write)(const void *scene, int k, FILE *file);
    void (*release)(void *scene);
    size_t picture;  // where in the scene its JobPicture is
} SceneKind;

// A JobPicture alone; the judge writes what belongs to it.
extern const SceneKind picture_kind;

#endif
