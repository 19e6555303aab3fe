# The programs that draw what explains, for the notes: as a followed pixel's program, with figures2d.c or
# figures3d.c in the place of pixel.c.

FIGURES := $(OUT)/tools/figures2d $(OUT)/tools/figures3d
$(OUT)/obj/tests/figures/%.o: EXTRA = $(GRADER_INCLUDES) -I common/follow -I solutions/00-hello-pixels -I solutions/04-camera-rays -I solutions/08-surface-area-heuristic -I solutions/10-realtime
$(OUT)/tools/figures2d: $(call objects,$(addprefix tests/figures/,figures2d.c plane2d.c draw_tree.c draw_arrays.c draw_descent.c draw_search.c draw_pixels.c draw_host.c draw_failed.c draw_weights.c draw_borders.c plane_trees.c) solutions/10-realtime/circle_tree.c) \
    $$(call follow_objects,solutions/03-kdtree-2d-render) $(OUT)/earlier/03-kdtree-2d-render.a
$(OUT)/tools/figures3d: $(call objects,$(addprefix tests/figures/,figures3d.c draw_ray.c draw_sphere.c draw_camera.c draw_planes.c \
    draw_balls.c draw_search3d.c draw_cost.c draw_light.c draw_tile.c draw_ways.c draw_lanes.c) solutions/08-surface-area-heuristic/kdtree3d_sah.c) \
    $$(call follow_objects,solutions/07-kdtree-3d-trace) $(OUT)/earlier/07-kdtree-3d-trace.a
$(OUT)/tools/plane_costs: $(call objects,$(addprefix tests/figures/,plane_costs.c plane_trees.c)) $(OUT)/earlier/03-kdtree-2d-render.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))
$(FIGURES): $(call objects,tests/figures/figures.c $(REFERENCE)) $(OUT)/libfollow.a $(OUT)/libjudge.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))
