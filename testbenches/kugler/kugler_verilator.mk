# kugler: light of a bump-mapped pixel by rotations and light maps, without dot products
# make -f kugler_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = kugler_recip.hex kugler_atan.hex kugler_tilt_map.hex kugler_diffuse_map.hex kugler_specular_map.hex
.PHONY: run clean
run: obj_kugler/Vkugler $(TABLES)
	obj_kugler/Vkugler kugler_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_kugler/Vkugler: $(HDL)/kugler.v kugler_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_kugler -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf obj_kugler
