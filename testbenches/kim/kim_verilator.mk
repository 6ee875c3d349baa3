# kim: light of a bump-mapped pixel by a matrix of sines and cosines and polar dot products
# make -f kim_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = kim_sincos.hex kim_recip.hex kim_atan.hex kim_diffuse.hex kim_specular.hex
.PHONY: run clean
run: obj_kim/Vkim $(TABLES)
	obj_kim/Vkim kim_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_kim/Vkim: $(HDL)/kim.v kim_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_kim -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf obj_kim
