# peercy: light and halfway vector in the texture frame, by matrix, with the bump vector normalised
# make -f peercy_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run clean
run: obj_peercy/Vpeercy
	obj_peercy/Vpeercy peercy_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_peercy/Vpeercy: $(HDL)/peercy.v peercy_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_peercy -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
clean:
	rm -rf obj_peercy
