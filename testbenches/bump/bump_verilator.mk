# bump: light of a bump-mapped pixel from light, halfway vector, normal and bump vector
# make -f bump_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = bump_sincos.hex bump_recip.hex bump_atan.hex bump_cos.hex bump_diffuse.hex bump_specular.hex
.PHONY: run clean
run: obj_bump/Vbump $(TABLES)
	obj_bump/Vbump bump_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_bump/Vbump: $(HDL)/bump.v bump_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_bump -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf obj_bump
