# emboss: texture coordinates displaced by the direction of a light, for embossing
# make -f emboss_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_emboss/Vemboss
	obj_emboss/Vemboss emboss_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_emboss/Vemboss: $(HDL)/emboss.v emboss_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_emboss -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_emboss
