# What libFuzzer feeds, compiled by clang together with the target: a list for each tests/fuzz/fuzz_*.c.

CLANG ?= $(firstword $(foreach c,clang clang-19 clang-15 clang-14,$(shell command -v $(c))))
FUZZED_forms = $(addprefix tests/copies/,forms.c forms_add.c expression.c form_list.c live_text.c macros.c remarks.c) tests/grader/submission/source_words.c \
    common/message.c $(MESSAGES)
FUZZED_graded = tests/class/grading/graded.c $(addprefix tests/grader/verdict/,diagnosis.c result.c) $(addprefix common/,message.c image.c) $(MESSAGES)
FUZZED_manifest = $(addprefix tests/grader/lab/,manifest.c json_place.c) $(addprefix common/,message.c number.c path.c) $(MESSAGES)
FUZZED_scene3d = $(wildcard common/scene3d*.c common/molecule*.c) $(MESSAGES) \
    $(addprefix common/,elements.c line_reader.c number.c scene_arguments.c text_file.c)
FUZZED_sections = tests/probes/sections.c
FUZZED_source = $(addprefix tests/grader/,lab/holes.c lab/skeleton.c submission/source_words.c submission/stands_out.c \
    submission/stands_out_files.c submission/contents.c submission/file_names.c \
    sandbox/folder.c) $(addprefix common/,message.c path.c text_file.c) $(MESSAGES)
FUZZED_unpack = $(addprefix tests/grader/submission/,unpack.c unpack_read.c contents.c copies.c file_kind.c file_names.c \
    bytes_write.c stands_out_unseen.c places.c place_read.c source_words.c stage.c stage_file.c) tests/grader/sandbox/folder.c \
    $(addprefix common/,message.c path.c) $(MESSAGES)
FUZZ_TARGETS := $(patsubst tests/fuzz/fuzz_%.c,fuzz-%,$(wildcard tests/fuzz/fuzz_*.c))

.PHONY: fuzz $(FUZZ_TARGETS)
fuzz: $(if $(TARGET),$(filter fuzz-$(TARGET),$(FUZZ_TARGETS)),$(FUZZ_TARGETS))  ## for authors: fuzz what reads files, [TARGET=unpack] for SECONDS=60 each (needs libclang-rt-dev)

$(FUZZ_TARGETS): fuzz-%:
	@mkdir -p $(BUILD)/fuzz/$*/new
	$(CLANG) -std=c11 -D_GNU_SOURCE -O1 -g -fsanitize=fuzzer,address,undefined \
	    -fno-sanitize-recover=undefined $(INCLUDES) $(GRADER_INCLUDES) tests/fuzz/fuzz_$*.c \
	    $(FUZZED_$*) -larchive -ljansson -lm -o $(BUILD)/fuzz/$*/fuzz
	$(BUILD)/fuzz/$*/fuzz $(addprefix -dict=,$(wildcard tests/fuzz/$*.dict)) -max_len=4096 \
	    -max_total_time="$${SECONDS:-60}" -artifact_prefix=$(BUILD)/fuzz/$*/ $(FUZZ_OPTIONS) \
	    $(BUILD)/fuzz/$*/new tests/fuzz/corpus/$*
