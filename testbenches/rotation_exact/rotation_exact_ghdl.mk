# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_exact_ghdl.mk             runs the VHDL testbench
# make -f rotation_exact_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_rotation_exact
run: ghdl_rotation_exact/work-obj08.cf
	ghdl -r $(GHDL) rotation_exact_tb
wave: ghdl_rotation_exact/work-obj08.cf
	ghdl -r $(GHDL) rotation_exact_tb --vcd=rotation_exact_tb.vcd
ghdl_rotation_exact/work-obj08.cf: $(HDL)/rotation_exact.vhd rotation_exact_tb.vhd
	rm -rf ghdl_rotation_exact
	mkdir ghdl_rotation_exact
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_rotation_exact rotation_exact_tb.vcd
