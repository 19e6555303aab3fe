# What authors need besides: a class, other systems, skeletons and handouts, the tests, known answers,
# the figures. The bench and fuzzing have files of their own. Nothing of this is in a handout.

setup_for = demo
grader: $(JUDGES)
CLASS_ROOMS := $(patsubst %/,%,$(wildcard tests/class/*/))
AUTHORS_INCLUDES += $(addprefix -I ,tests/mutation tests/memcheck $(CLASS_ROOMS) tests/copies)

# ---- Known answers, and mechanical ones -----------------------------------------------------

$(OUT)/libmutation.a: $(call objects,$(addprefix tests/mutation/,mutations.c edits.c known_answer.c tried_alone.c groups.c groups_try.c))
	$(archive)
$(addprefix $(OUT)/tools/,known mutants mutate): $(OUT)/tools/%: $(OUT)/obj/tests/mutation/%.c.o $(OUT)/libmutation.a $(OUT)/libgrader.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))

# ---- A class ---------------------------------------------------------------------------------

CLASS_LIBRARIES = -larchive -lnettle -licui18n -licuuc
$(OUT)/libclass.a: $(call objects,$(filter-out %_tool.c,$(foreach room,$(CLASS_ROOMS),$(wildcard $(room)/*.c))))
	$(archive)
$(call objects,tests/class/pages/class_page.c): tests/class/pages/class.html
$(call objects,tests/class/pages/class_slides.c): tests/class/pages/slides.html
$(call objects,tests/class/term/term_page.c): tests/class/term/term.html
$(OUT)/tools/gradebook: $(call objects,tests/class/gradebook_tool.c) $(OUT)/libclass.a $(OUT)/libgrader.a $(OUT)/libcommon.a
	$(call link,$(LIBRARIES) $(CLASS_LIBRARIES))

# An instructor's own points (POINTS=points.csv) as a manifest, for everything that reads one.
$(OUT)/tools/points: $(call objects,tests/class/points/points_tool.c) $(OUT)/libclass.a $(OUT)/libgrader.a $(OUT)/libcommon.a
	$(call link,$(LIBRARIES) $(CLASS_LIBRARIES))
own_points = $(if $(and $(POINTS),$(graded_lab)),$(OUT)/tools/points "$(graded_lab)" "$$POINTS" $(OUT)/own-points.json &&)
grade pack gradescope autolab prairielearn github gitlab vpl: $(if $(POINTS),$(OUT)/tools/points)

grader: $(addprefix $(OUT)/tools/,holes gradebook points term known mutants mutate)
.PHONY: grade-class
grade-class: graded $(addprefix $(OUT)/tools/,gradebook points)  ## grade a class: LAB=03 SUBMISSIONS=folder or archive [OUTPUT=folder] [ENGINE=slurm] [SEED=n] [ONLY=failed|latest] [JOBS=n] [TIME_LIMIT=seconds] [AGAIN=1] [LIST=file.csv] [COLUMN=title] [WHO=file.csv] [CHANGES=file.csv] [POINTS=file.csv] [DUE="2026-11-25 23:59"] [LATE=10%/day,2days] [AGAINST=gradebook.json] [NOTHING=0|blank] [NAMES=no]
	@exec tests/class/grading/grade_class.sh --make --build $(OUT)

.PHONY: feedback
feedback: $(OUT)/tools/gradebook  ## give a graded class its reports back: LAB=03 FOR=moodle|canvas|ilias|mail|folders [OUTPUT=folder] [LIST=file.csv] [WHO=file.csv] [CHANGES=file.csv] [DUE=time] [LATE=points]
	@$(say_which_lab)
	@$(OUT)/tools/gradebook --make feedback -- "$$FOR" "$(if $(OUTPUT),$$OUTPUT,$(OUT)/class/$(firstword $(subst -, ,$(graded_lab))))"

# The folders of CLASSES are words; the shell expands nothing in them (set -f).
$(OUT)/tools/term: $(call objects,tests/class/term/term_tool.c) $(OUT)/libclass.a $(OUT)/libgrader.a $(OUT)/libcommon.a
	$(call link,$(LIBRARIES) $(CLASS_LIBRARIES))
classes_in = set -f; test -n "$$CLASSES" || { echo 'make $@: say which folders: make $@ CLASSES="../grades-00 ../grades-03"' >&2; exit 2; }
.PHONY: term class-figures
term: $(OUT)/tools/term  ## the labs of a term in one table: CLASSES="folder folder ..." [OUTPUT=folder] [PASS=points] [NEED=labs] [EXCEL=1]
	@$(classes_in); $(OUT)/tools/term --make table -- "$(if $(OUTPUT),$$OUTPUT,$(OUT)/term)" $$CLASSES
class-figures: $(OUT)/tools/term  ## where classes fail, by lab and check, without any names: CLASSES="folder folder ..." [OUTPUT=folder]
	@$(classes_in); $(OUT)/tools/term figures -- "$(if $(OUTPUT),$$OUTPUT,$(OUT)/term)" $$CLASSES

include tests/copies/copies.mk

# ---- Other systems (tests/systems/README.md) ------------------------------------------------

# The grader is run through this, which writes its result in more forms.
through_formats = $(if $(and $(FORMAT),$(graded_lab)),tests/systems/formats/write.sh "$$FORMAT" \
    "$(OUT)/grade/$(firstword $(subst -, ,$(graded_lab)))" "$(graded_lab)")

# Bundles, in build/systems.
.PHONY: gradescope autolab prairielearn github gitlab vpl
gradescope:  ## the autograder of LAB=03 for Gradescope [HIDE=after_due_date|after_published] [THROTTLE=5/day] (a result in other formats: make grade LAB=03 FORMAT=junit,tap)
autolab:  ## the assessment of LAB=03 for Autolab
prairielearn:  ## the question of LAB=03 for PrairieLearn, and its grader's image
github:  ## a workflow that grades LAB=03 in a repository on GitHub
gitlab:  ## the same for a repository on GitLab
vpl:  ## what Moodle's VPL needs to grade LAB=03 by its handout
gradescope autolab prairielearn github gitlab vpl:
	@$(say_which_lab)
	@$(own_points) tests/systems/bundle.sh $@ "$$LAB" $(BUILD)/systems $(if $(own_points),$(OUT)/own-points.json)

# ---- Skeletons, handouts, pictures ----------------------------------------------------------

# What a message needs, for tools that need little else of common/.
MESSAGES = $(addprefix common/,complain.c clean_text.c utf8.c)
$(OUT)/tools/holes: $(call objects,tests/tools/holes.c tests/grader/lab/holes.c common/message.c common/text_file.c $(MESSAGES))
	$(call link)

include tests/figures/figures.mk
.PHONY: skeletons handout pack release release-pack demo figures format
skeletons: $(OUT)/tools/holes  ## for authors: cut labs/ anew from solutions/; the old one goes to build/labs-replaced
	@if [ -d labs ]; then rm -rf $(BUILD)/labs-replaced && cp -r labs $(BUILD)/labs-replaced; fi
	@tests/tools/cut_labs.sh $(OUT)/tools/holes labs

handout:  ## install what is missing, pack what students get: LAB=03 [POINTS=file.csv]
	@$(say_which_lab)
	@common/setup/install.sh handout
	@$(MAKE) --no-print-directory pack
pack: $(OUT)/tools/holes
	@$(own_points) tests/handout/pack.sh $(OUT)/tools "$$LAB" $(OUT)/handout $(if $(own_points),$(OUT)/own-points.json)

release:  ## install what is missing, make slides, notes and all handouts for lecturers, in build/release
	@common/setup/install.sh demo notes handout
	@$(MAKE) --no-print-directory release-pack
release-pack: notes-html notes-pdf $(OUT)/tools/holes grader
	@rm -rf $(OUT)/release-handouts
	@for lab in $(LABS); do tests/handout/pack.sh $(OUT)/tools $$lab $(OUT)/release-handouts >/dev/null || exit 1; done
	@printf '%s\n' $(NOTES_HTML) $(NOTES_PDF) | tests/handout/release.sh $(NOTES) $(OUT)/release-handouts $(BUILD)/release

demo:  ## install what is missing, render every solution, grade a small class
	@common/setup/install.sh demo
	@$(MAKE) --no-print-directory all
	@tests/demo.sh $(OUT)

figures: all views pixels $(FIGURES)  ## draw the pictures of the READMEs and notes anew
	tests/figures.sh slides-notes/figures $(OUT) >/dev/null

# Texts of answers are as somebody wrote them.
NOT_OURS = -e ^labs/ -e ^tests/stubs/ -e ^tests/attacks/
# Older ones, that editors may have, know no InsertBraces: it is not in .clang-format.
format:  ## put every source into the one format
	clang-format-19 --style='{BasedOnStyle: InheritParentConfig, InsertBraces: true}' -i $$(git ls-files -- '*.c' '*.h' '*.cpp' '*.cl' | grep -v $(NOT_OURS))

# ---- Judges of all labs, for tests and tools ------------------------------------------------

$(OUT)/libjudge.a: $(call objects,$(filter-out %/judge_tool.c,$(wildcard $(JUDGE_ROOMS:%=%/*.c))) $(BUILDERS))
	$(archive)
# The table, anew when a lab comes or goes.
$(OUT)/obj/tests/judge/judges.c.o: EXTRA = $(GRADER_INCLUDES) -D'JUDGES=$(foreach lab,$(JUDGED),JUDGE($(firstword $(subst -, ,$(lab)))))'
$(OUT)/obj/tests/judge/judges.c.o: tests/judge

# ---- Tests ----------------------------------------------------------------------------------

UNIT_TESTS := $(patsubst tests/unit/%.c,$(OUT)/tests/%,$(wildcard tests/unit/test_*.c))
$(UNIT_TESTS): $(OUT)/tests/%: $(OUT)/obj/tests/unit/%.c.o $(OUT)/libcopies.a $(OUT)/libclass.a $(OUT)/libmutation.a $(OUT)/libgrader.a $(OUT)/libjudge.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES) -larchive $(CLASS_LIBRARIES) -lcriterion)
$(OUT)/tests/test_memcheck: $(call objects,$(filter-out %/memcheck.c,$(MEMCHECK_SOURCES)))
$(OUT)/tests/test_sanitizer_log: $(call objects,tests/memcheck/sanitizer_log.c)

# Fuzz targets, each as a function of its name, for the test that runs their corpus through.
$(OUT)/obj/tests/fuzz/%.c.o: EXTRA = $(GRADER_INCLUDES) -DLLVMFuzzerTestOneInput=$(basename $(notdir $<))
$(OUT)/obj/tests/unit/test_corpus.c.o $(OUT)/obj/tests/unit/test_nff_round_trip.c.o: \
    EXTRA = $(GRADER_INCLUDES) -I tests/fuzz
$(OUT)/tests/test_corpus: $(call objects,$(wildcard tests/fuzz/fuzz_*.c))

# The parts of a window that need none.
$(OUT)/obj/tests/unit/test_flight.c.o $(OUT)/obj/tests/unit/test_poses.c.o: EXTRA = $(GRADER_INCLUDES) -I common/view -I common/follow
$(OUT)/tests/test_flight: $(call objects,common/follow/flight.c)
$(OUT)/tests/test_poses: $(call objects,common/view/poses.c common/follow/world.c)

# The frame of 3D trees with OpenMP.
$(OUT)/obj/tests/unit/test_tree3d_threads.c.o: EXTRA = $(GRADER_INCLUDES) -I solutions/08-surface-area-heuristic -fopenmp
$(OUT)/tests/test_tree3d_threads: LDFLAGS += -fopenmp

# What a figure says of trees in the plane.
$(OUT)/obj/tests/unit/test_plane_trees.c.o: EXTRA = $(GRADER_INCLUDES) -I tests/figures
$(OUT)/tests/test_plane_trees: $(call objects,tests/figures/plane_trees.c)

# What the bench counts and changes.
$(OUT)/obj/tests/unit/test_bench_builds.c.o $(OUT)/obj/tests/unit/test_bench_tricks.c.o: EXTRA = $(BENCH_INCLUDES) -I tests/bench
$(OUT)/tests/test_bench_tricks: $(call objects,tests/bench/trick.c tests/bench/hidden_circles.c \
    solutions/10-realtime/circle_tree.c $(BUILDERS))
$(OUT)/tests/test_bench_builds: LDFLAGS += $(MEMORY_COUNTING)
$(OUT)/tests/test_bench_builds: $(call objects,$(addprefix tests/bench/,case_build.c counted_memory.c handed_on.c) $(BUILDERS) \
    solutions/08-surface-area-heuristic/kdtree3d_sah.c)

# The tree of lab 10's circles.
$(OUT)/obj/tests/unit/test_circle_tree.c.o: EXTRA = $(GRADER_INCLUDES) -I solutions/10-realtime
$(OUT)/tests/test_circle_tree: $(call objects,solutions/10-realtime/circle_tree.c $(BUILDERS))

# Lab 02's builder with a distribute() that returns more circles than it was given.
TOO_MANY = $(OUT)/wrong/returns-too-many.c
$(TOO_MANY): solutions/02-kdtree-2d-build/kdtree2d_build.c tests/known/02-kdtree-2d-build/wrong.diff $(OUT)/tools/holes $(OUT)/tools/known
	@mkdir -p $(@D)
	@$(OUT)/tools/known read 02-kdtree-2d-build returns-too-many >$@.answer
	@$(OUT)/tools/holes fill $< distribute $@.answer >$@.new && mv $@.new $@
$(OUT)/obj/tests/unit/test_builder_guard.c.o: EXTRA = $(GRADER_INCLUDES) -I $(dir $(TOO_MANY))
$(OUT)/obj/tests/unit/test_builder_guard.c.o: $(TOO_MANY)

# What the suites use: a comparison of two pictures, a part of one, what rays hit and how many there are; for the attacks a
# listener that must not be reached, a wrapper that sees survivors, and a table of what a seed shows; a
# judge over answers that exhaust it; a kernel without Landlock, a device without images.
SUITE_TOOLS = $(addprefix $(OUT)/tools/,compare compare_mirrors count_hits count_rays crop greedy_judge learned listener left_behind older_kernel)
$(SUITE_TOOLS): $(OUT)/tools/%: $(OUT)/obj/tests/tools/%.c.o $(OUT)/libgrader.a $(OUT)/libjudge.a $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES))
# Two of them in one program, which loads the library for pictures once (tests/tools/pictures.c).
SERVED = compare crop
$(OUT)/obj/served/%.o: tests/tools/%.c $(FLAG_FILES)
	$(call compile,$(CC) $(CFLAGS) -Dmain=$*_main, for pictures)
$(OUT)/tools/pictures: $(call objects,tests/tools/pictures.c) $(SERVED:%=$(OUT)/obj/served/%.o) $(OUT)/libcommon.a | $(OUT)/libimage_codec.so
	$(call link,$(LIBRARIES) -ldl)
$(OUT)/tests/no_images.so: tests/tools/no_images.c
	@mkdir -p $(@D)
	$(call say,link    $@)$(CC) $(CFLAGS) -fPIC -shared $< -ldl -o $@

# A unit test's own code runs once: to optimise it takes longer than it saves. What it tests is optimised.
$(OUT)/obj/tests/unit/%.c.o: OPTIMISATION = -O0 -g
# But for one that builds many trees.
$(OUT)/obj/tests/unit/test_replays.c.o: OPTIMISATION = -O2 -g

# The solutions' answers to the jobs of some seeds, which unit tests damage (tests/unit/right_answers.h). No known
# answer has a / in its name, so that only the solution is run.
UNIT_SEEDS = 1 2 3 5 9
UNIT_ANSWERS := $(patsubst solutions/%/lab.json,$(NATIVE)/answers/%/9,$(wildcard solutions/*/lab.json))
$(UNIT_ANSWERS): $(NATIVE)/answers/%/9: $(wildcard kernels/* solutions/*/*.[ch]*) $(JUDGES) $(OUT)/tools/mutants \
    $$(filter $(NATIVE)/probes/$$* $(NATIVE)/probes/$$*.o,$(PROBES:$(OUT)/%=$(NATIVE)/%)) | native
	@mkdir -p $(@D)
	$(call say,answer  $*)for seed in $(UNIT_SEEDS); do rm -f $(@D)/$$seed && \
	    $(OUT)/tools/mutants --only / --lab $* --seed $$seed --answers $(@D) --build $(NATIVE) --sandbox none >/dev/null || exit; done

# In `make test-all` unit tests run under the sanitizers, but for this one: PoCL's compiler is not built for
# them. In `make test` they run without: this second build takes longer than the first.
NATIVE_TEST = $(OUT)/tests/test_cl_setup

.PHONY: unit-tests watched suites quick tests check test test-all test-scale test-seeds test-mutants test-attacks
unit-tests: $(filter-out $(NATIVE_TEST),$(UNIT_TESTS))
# What the suites run with the sanitizers: solutions, whose skeletons have the same code around the holes.
watched: unit-tests $(filter $(OUT)/solutions/% $(OUT)/view/solutions/% $(OUT)/pixel/solutions/%,$(PROGRAMS) $(VIEWS) $(PIXELS))
# All that `make test` runs, which tries each suite's quick part (tests/tap.sh): with SDL and clang's sanitizers where they are.
suites: all $(UNIT_ANSWERS) $(NATIVE_TEST) $(SUITE_TOOLS) $(OUT)/tools/pictures $(OUT)/tests/no_images.so native \
    $(filter $(OUT)/pixel/solutions/%,$(PIXELS)) $$(if $$(shell $$(has_sdl) && echo yes),$$(SEEN_SOLUTIONS)) \
    $$(if $$(shell $$(has_sanitizers) && echo yes),memcheck-libraries)
SEEN_SOLUTIONS := $(filter $(OUT)/view/solutions/%,$(VIEWS))
has_sdl = pkg-config --exists sdl2 SDL2_ttf 2>/dev/null
has_sanitizers = echo 'int main(void) { return 0; }' | clang -fsanitize=memory -x c - -o /dev/null 2>/dev/null
quick: suites unit-tests
# The bench is built here, too: it must not break unnoticed.
tests: suites memcheck-libraries views pixels $(FIGURES) $(OUT)/tools/plane_costs $$(BENCH_PROGRAMS)  ## build all that the tests run
	@$(MAKE) --no-print-directory SANITIZE=1 watched
check: tests  ## run all tests without installing anything
	@BUILD="$(BUILD)" tests/run.sh
test:  ## install what is missing and run the quick part of the tests: minutes
	@common/setup/install.sh test
	@$(MAKE) --no-print-directory quick
	@QUICK=1 BUILD="$(BUILD)" tests/run.sh
test-all:  ## install what is missing and run every test, end to end
	@common/setup/install.sh test test-all
	@$(MAKE) --no-print-directory check
test-scale:  ## install what is missing, grade a class of N=1000, try mechanical mutants of every lab (long)
	@common/setup/install.sh test test-all scale
	@$(MAKE) --no-print-directory grader
	@BUILD="$(BUILD)" tests/run.sh slurm
	@tests/scale/run.sh "$${N:-1000}" $(OUT)
	@$(MAKE) --no-print-directory test-seeds
	@$(MAKE) --no-print-directory test-mutants
	@$(MAKE) --no-print-directory test-attacks
test-seeds: native  ## try the known answers of every lab, or of LAB=03, with 20 seeds: natively, and a sample with PoCL (long)
	@BUILD="$(BUILD)" SEEDS=20 sh tests/suites/native.sh
	@BUILD="$(BUILD)" SEEDS=20 sh tests/suites/mutants.sh
test-mutants: grader  ## try mechanical mutants of every lab, or of LAB=03 (long)
	@tests/mutate.sh $(OUT) $${LAB:+"$$LAB"}
test-attacks: tests  ## try every attack in every sandbox, as root (long)
	@BUILD="$(BUILD)" SANDBOXES="bubblewrap landlock user" sh tests/suites/attacks.sh tests/attacks/*/*

include tests/fuzz/fuzz.mk tests/bench/bench.mk
