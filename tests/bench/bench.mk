# How fast: the bench of naive against kd-tree, in 2D and in 3D, and of building.

# Embree, which the 3D bench compares with where its package is installed: version 4, or 3.
EMBREE := $(firstword $(foreach v,4 3,$(if $(wildcard /usr/include/embree$(v)/rtcore.h),$(v))))
BENCH_INCLUDES = $(BUILDER_INCLUDES) $(addprefix -I solutions/,05-spheres 08-surface-area-heuristic 10-realtime)
$(OUT)/obj/tests/bench/%.o: EXTRA = $(BENCH_INCLUDES) \
    -DNAIVE_OPTIONS='"$(call include_path,01-naive-2d)"' \
    -DKDTREE_OPTIONS='"$(call include_path,03-kdtree-2d-render)"' \
    -DSPHERES_OPTIONS='"$(call include_path,05-spheres)"' \
    -DTRACE_OPTIONS='"$(call include_path,07-kdtree-3d-trace)"' \
    -DMIRRORS_OPTIONS='"$(call include_path,10-realtime)"'
# Cairo, which the 2D bench compares with where its package is installed.
CAIRO := $(if $(wildcard /usr/include/cairo/cairo.h),1)
# For this machine and in vectors, as OpenCL compiles the kernels.
$(OUT)/obj/tests/bench/painter.c.o: EXTRA = $(BENCH_INCLUDES) -O3 -march=native -fno-math-errno
$(OUT)/obj/tests/bench/cairo_peer.c.o: EXTRA = $(BENCH_INCLUDES) $(if $(CAIRO),-DWITH_CAIRO $(shell pkg-config --cflags cairo))
# The same; anew when a peer was installed since.
EMBREE_OBJECTS = $(OUT)/obj/tests/bench/embree_peer.c.o $(OUT)/obj/tests/bench/embree_rays.c.o
$(EMBREE_OBJECTS): EXTRA = $(BENCH_INCLUDES) -O3 -march=native \
    -fno-math-errno -fno-trapping-math \
    $(if $(EMBREE),-DWITH_EMBREE=$(EMBREE))
$(EMBREE_OBJECTS) $(OUT)/obj/tests/bench/cairo_peer.c.o: $(OUT)/peers
# The frame of 3D trees on several threads: in bench3d alone, which says on how many.
GROW_ON_THREADS = tests/bench/grow_on_threads.c
$(OUT)/obj/$(GROW_ON_THREADS).o $(OUT)/obj/tests/bench/bench3d.c.o: EXTRA = $(BENCH_INCLUDES) -fopenmp
$(OUT)/tools/bench3d: $(call objects,$(GROW_ON_THREADS))
$(OUT)/tools/bench3d: LDFLAGS += -fopenmp
.PHONY: always
$(OUT)/peers: always
	@mkdir -p $(@D)
	@echo "$(EMBREE) $(CAIRO)" | cmp -s - $@ || echo "$(EMBREE) $(CAIRO)" >$@

BENCHES = bench2d bench3d bench_tricks bench_builds
BENCH_PROGRAMS = $(BENCHES:%=$(OUT)/tools/%)
$(OUT)/libbench.a: $(call objects,$(filter-out $(BENCHES:%=tests/bench/%.c) $(GROW_ON_THREADS),$(wildcard tests/bench/*.c)) \
    $(BUILDERS) solutions/05-spheres/scene_buffers.c \
    $(addprefix solutions/08-surface-area-heuristic/,kdtree3d_sah.c tree_buffers.c tree_report.c) \
    $(addprefix solutions/10-realtime/,circle_tree.c circles.c tile_buffers.c))
	$(archive)

# Allocations of whoever counts them lead to counted_memory.c.
MEMORY_COUNTING = -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free
$(OUT)/tools/bench_builds: LDFLAGS += $(MEMORY_COUNTING)
$(BENCH_PROGRAMS): $(OUT)/tools/%: $(OUT)/obj/tests/bench/%.c.o $(OUT)/libbench.a $(OUT)/libcommon.a
	$(call link,$(LIBRARIES) $(if $(EMBREE),-lembree$(EMBREE)) $(if $(CAIRO),-lcairo) -pthread -lm)

.PHONY: bench
bench:  ## install what is missing, measure naive against kd-tree in 2D and 3D, lab 10's tricks, and how builds grow; plot to build/bench
	@common/setup/install.sh bench
	@$(MAKE) --no-print-directory $(BENCH_PROGRAMS)
	@for bench in $(BENCHES); do \
	    $(OUT)/tools/$$bench --output $(OUT)/bench $(if $(DEVICE),--device "$$DEVICE") \
	        $(if $(ROUNDS),--rounds "$$ROUNDS") || exit 1; done
	@$(MAKE) --no-print-directory all native
	@ROUNDS="$${ROUNDS:-5}" tests/bench/bench_watch.sh $(OUT)/bench
	@tests/bench/tables.sh $(OUT)/bench
