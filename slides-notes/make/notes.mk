# Notes, slides and the course's site, in two editions: `make notes`. Only this needs pandoc and Chromium.

include slides-notes/touch/touch.mk

NOTES := $(BUILD)/notes
NOTES_MAKE := slides-notes/make
CHAPTERS := $(patsubst slides-notes/notes-%.md,%,$(wildcard slides-notes/notes-*.md))
# Those whose slides are made in German, too.
GERMAN := 2d 3d
# Markdown files that become pages as they are, at the same places; what links to others keeps only its words.
NOTES_PAGES := README.md slides-notes/README.md slides-notes/slides-and-course.md slides-notes/questions.md tests/GRADING.md tests/bench/RESULTS.md \
    tests/INSTRUCTORS.md tests/what-protects-a-grade.md common/SCENES.md common/DATA-FLOW.md common/setup/TROUBLESHOOTING.md $(wildcard labs/*/*.md)
# Those that hold answers: of the instructor's edition only.
NOTES_PAGES_student :=
NOTES_PAGES_instructor := slides-notes/TEACHING.md
NOTES_LINKED := $(NOTES_PAGES) $(wildcard slides-notes/notes-*.md)
NOTES_TOOLS := $(wildcard $(NOTES_MAKE)/*.lua $(NOTES_MAKE)/*.css slides-notes/touch/*.css $(NOTES_MAKE)/*.js) $(NOTES_MAKE)/page.html $(NOTES_MAKE)/build.sh

# What the programs counted, for the numbers in the texts: a run for each line of runs.txt.
NOTES_RUNS := $(patsubst %,$(NOTES)/runs/%.json,$(shell sed -n 's/^\([0-9][^ ]*\) .*/\1/p' $(NOTES_MAKE)/runs.txt))
# The lab of a run. Without a filter: a % in a prerequisite would be the target's.
lab_of_run = $(foreach lab,$(LABS),$(if $(findstring /$(firstword $(subst -, ,$(1)))-,/$(lab)),$(lab)))
$(NOTES_RUNS): $(NOTES)/runs/%.json: $(NOTES_MAKE)/runs.txt $(NOTES_MAKE)/run.sh \
    $$(addprefix $(OUT)/solutions/,$$(call lab_of_run,$$*)) | $(OUT)/tools/known $(OUT)/tools/compare
	@mkdir -p $(@D)
	$(call say,count   $*)$(NOTES_MAKE)/run.sh $* $(OUT) $@
# What a pixel is expected to do in lab 08's trees in the plane, which no lab's program grows.
$(NOTES)/runs/08-plane.json: $(OUT)/tools/plane_costs
	@mkdir -p $(@D)
	$(call say,count   08-plane)$< $@ >/dev/null
NOTES_RUNS += $(NOTES)/runs/08-plane.json
# Those whose numbers stand in the texts $(1).
runs_of = $(patsubst %,$(NOTES)/runs/%.json,$(shell grep -oh '<!-- [0-9][0-9]-[^ ]*: ' $(1) | sort -u | sed 's/<!-- //; s/: //'))
chapter_runs = $(call runs_of,slides-notes/notes-$(1).md slides-notes/questions.md)

# A page: of edition $(1) and form $(2), from the source that comes first.
define page
$(call say,page    $@)$(NOTES_MAKE)/build.sh $(NOTES)/$(1) $(1) $(2) $< $@ "$(NOTES_LINKED) $(NOTES_PAGES_$(1))" $(TOUCH)
endef
define notes_edition  # the rules of the edition $(1)
NOTES_HTML += $(NOTES)/$(1)/index.html $(patsubst %.md,$(NOTES)/$(1)/%.html,$(NOTES_PAGES) $(NOTES_PAGES_$(1))) \
    $(foreach chapter,$(CHAPTERS),$(NOTES)/$(1)/slides-notes/notes-$(chapter).html $(NOTES)/$(1)/slides-notes/slides-$(chapter).html) \
    $(foreach chapter,$(GERMAN),$(NOTES)/$(1)/slides-notes/slides-$(chapter).de.html)
NOTES_PDF += $(foreach chapter,$(CHAPTERS) $(GERMAN:=.de),$(NOTES)/$(1)/slides-notes/slides-$(chapter).pdf) \
    $(foreach chapter,$(CHAPTERS),$(NOTES)/$(1)/slides-notes/notes-$(chapter).pdf)
$(NOTES)/$(1)/slides-notes/notes-%.html: slides-notes/notes-%.md slides-notes/questions.md $(NOTES_TOOLS) $$$$(call chapter_runs,$$$$*) $(TOUCH)
	$$(call page,$(1),notes)
$(NOTES)/$(1)/slides-notes/slides-%.html: slides-notes/notes-%.md slides-notes/questions.md $(NOTES_TOOLS) $$$$(call chapter_runs,$$$$*)
	$$(call page,$(1),slides)
$(NOTES)/$(1)/slides-notes/slides-%.de.html: slides-notes/notes-%.md slides-notes/questions.md slides-notes/german.po $(NOTES_TOOLS) $$$$(call chapter_runs,$$$$*)
	$$(call page,$(1),slides)
$(NOTES)/$(1)/index.html: slides-notes/index.md $(NOTES_TOOLS)
	$$(call page,$(1),page)
$(NOTES)/$(1)/%.html: %.md slides-notes/questions.md $(NOTES_TOOLS) $$$$(call runs_of,$$$$*.md slides-notes/questions.md)
	$$(call page,$(1),page)
endef
$(foreach edition,student instructor,$(eval $(call notes_edition,$(edition))))
# Listings are cut from here, figures shown.
$(NOTES_HTML): $(wildcard labs/*/*.[ch]* solutions/*/*.[ch]* slides-notes/figures/*)

$(NOTES)/%.pdf: $(NOTES)/%.html $(NOTES_MAKE)/print.sh
	$(call say,print   $@)$(NOTES_MAKE)/print.sh $< $@

.PHONY: notes notes-html notes-pdf notes-runs german
notes:  ## install what is missing, make notes, slides and the course's site, for students and for instructors
	@common/setup/install.sh demo notes  # demo: what the solutions need, whose counts stand in the texts
	@command -v pandoc >/dev/null || { echo "make notes: found no pandoc, expected it to be installed" >&2; exit 1; }
	@$(MAKE) --no-print-directory notes-html
	@slides-notes/touch/compiler.sh >/dev/null || \
	    echo "make notes: found no clang, lld, wasi-libc and libclang-rt-dev-wasm32: no figure can be touched"
	@if $(NOTES_MAKE)/browser.sh >/dev/null; then $(MAKE) --no-print-directory notes-pdf; \
	else echo "make notes: found no Chromium: without PDF"; fi
	@echo "for students: $(NOTES)/student/index.html"
	@echo "for instructors, with the key and speaker notes: $(NOTES)/instructor/index.html"
notes-html: $(NOTES_HTML)
notes-pdf: $(NOTES_PDF)
notes-runs: $(NOTES_RUNS)
german: $(NOTES_RUNS)  ## take changed paragraphs of the slides into slides-notes/german.po, to be translated
	@$(NOTES_MAKE)/german.sh $(NOTES) $(GERMAN)
