# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_printed_verilator.mk        builds the C++ harness and runs it on the vectors
# HDL=DIR says where the module is, if not here.
HDL ?= .
TABLES = rotation_printed_sincos.hex rotation_printed_asin.hex rotation_printed_recip_sin.hex rotation_printed_recip_cos.hex rotation_printed_atan.hex rotation_printed_prop.hex
.PHONY: run clean
run: obj_rotation_printed/Vrotation_printed $(TABLES)
	obj_rotation_printed/Vrotation_printed rotation_printed_vectors.txt
# Verilator would add -Os, which undoes -O2.
obj_rotation_printed/Vrotation_printed: $(HDL)/rotation_printed.v rotation_printed_harness.cpp
	verilator --cc --exe --build -Wall --Mdir obj_rotation_printed -CFLAGS "-O2" \
	    -MAKEFLAGS "OPT_FAST= OPT_SLOW= OPT_GLOBAL=" $^
ifneq ($(HDL),.)
$(TABLES): %.hex: $(HDL)/%.hex
	cp $< $@
endif
clean:
	rm -rf obj_rotation_printed
