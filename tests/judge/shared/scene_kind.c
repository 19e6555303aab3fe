// Scenes of which the judge keeps no more than their pictures (see scene_kind.h).
#include "scene_kind.h"

#include "job_picture.h"

static void release(void *scene)
{
    JobPicture *picture = scene;
    expected_picture_free(&picture->expected);
}

const SceneKind picture_kind = {.release = release};
