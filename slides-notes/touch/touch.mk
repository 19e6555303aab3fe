# Figures that can be touched: what draws the still ones, the recorder, the builders and the kernels, compiled
# to WebAssembly. What a page takes of it is $(TOUCH); it is empty where no compiler is there for it.

# Asked for only where pages are made.
TOUCH_CLANG := $(if $(filter notes-% release-pack $(BUILD)/notes/%,$(MAKECMDGOALS)),$(shell slides-notes/touch/compiler.sh))
TOUCH := $(if $(TOUCH_CLANG),$(BUILD)/notes/touch.html)
TOUCH_OUT := $(BUILD)/notes/touch

# In the place of record.c's device, of tests/follow and of scene2d_open.c stand page_device.c, no_reference.c
# and scenes.c.
TOUCH_SOURCES := $(wildcard slides-notes/touch/*.c) \
    $(addprefix tests/figures/,plane2d.c draw_tree.c draw_search.c draw_search3d.c draw_cost.c) \
    $(addprefix common/follow/,followed.c followed_text.c record.c world.c circles.c spheres.c eye.c flight.c no_reference.c) \
    $(addprefix common/,svg.c message.c complain.c clean_text.c utf8.c number.c stats.c cl_memory.c cl_check.c) \
    $(addprefix common/,tree2d.c tree2d_grow.c scene2d.c scene2d_generate.c scene2d_random.c scene2d_edge_cases.c scene_arguments.c) \
    $(addprefix common/,tree3d.c tree3d_grow.c scene3d.c scene3d_view.c scene3d_generate.c scene3d_edge_cases.c) \
    $(addprefix common/,scene3d_random.c scene3d_lattice.c scene3d_sphereflake.c scene3d_uneven.c) \
    $(addprefix solutions/,02-kdtree-2d-build/kdtree2d_build.c 04-camera-rays/camera_from_view.c 05-spheres/scene_buffers.c) \
    solutions/06-kdtree-3d-build/kdtree3d_build.c solutions/08-surface-area-heuristic/kdtree3d_sah.c
TOUCH_KERNELS := slides-notes/touch/builtins.cl common/follow/steps/03-kdtree-2d-render.cl common/follow/steps/07-kdtree-3d-trace.cl
TOUCH_OBJECTS := $(patsubst %,$(TOUCH_OUT)/%.o,$(TOUCH_SOURCES) $(TOUCH_KERNELS))

# Arithmetic as it is written: no two operations become one.
TOUCH_COMPILE = $(TOUCH_CLANG) --target=wasm32-wasi --sysroot=/usr -Oz -ffp-contract=off -Wall -Wextra -Werror -MMD -MP
TOUCH_INCLUDES := $(INCLUDES) -I common/follow -I common/follow/steps -I tests/figures -I slides-notes/touch $(addprefix -I ,$(wildcard solutions/0*))
$(TOUCH_OUT)/%.c.o: %.c slides-notes/touch/touch.mk
	@mkdir -p $(@D)
	$(call say,wasm    $<)$(TOUCH_COMPILE) -std=c11 -D_GNU_SOURCE $(TOUCH_INCLUDES) -c $< -o $@
# A kernel is a function as others: WebAssembly knows no second way to call one.
$(TOUCH_OUT)/%.cl.o: %.cl slides-notes/touch/touch.mk
	@mkdir -p $(@D)
	$(call say,wasm    $<)$(TOUCH_COMPILE) -x cl -cl-std=CL1.2 -Dkernel= -Wno-unused-function \
	    -Xclang -finclude-default-header $(TOUCH_INCLUDES) -c $< -o $@
# A work-item's steps lie on the stack.
$(TOUCH_OUT).wasm: $(TOUCH_OBJECTS)
	$(call say,link    $@)$(TOUCH_CLANG) --target=wasm32-wasi --sysroot=/usr -mexec-model=reactor \
	    -Wl,-z,stack-size=1048576,--strip-all $^ -o $@
# As a page holds it: in itself, so that it can be opened as a file.
$(TOUCH_OUT).html: $(TOUCH_OUT).wasm slides-notes/touch/touch.js
	@{ printf '<script>\nconst touchProgram = "'; base64 -w 0 $<; printf '";\n'; cat slides-notes/touch/touch.js; \
	    printf '</script>\n'; } >$@

-include $(TOUCH_OBJECTS:.o=.d)
