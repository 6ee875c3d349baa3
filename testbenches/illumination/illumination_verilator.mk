# illumination: light of a pixel from light, halfway and perturbed normal vector in the texture frame
# make -f illumination_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_illumination/Villumination
	obj_illumination/Villumination illumination_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_illumination/Villumination: $(HDL)/illumination.v illumination_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_illumination -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_illumination
