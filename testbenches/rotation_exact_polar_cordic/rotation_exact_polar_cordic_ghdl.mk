# rotation: turns a direction in polar form into the frame of a surface normal
# make -f rotation_exact_polar_cordic_ghdl.mk             runs the VHDL testbench
# make -f rotation_exact_polar_cordic_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_rotation_exact_polar_cordic
run: ghdl_rotation_exact_polar_cordic/work-obj08.cf
	ghdl -r $(GHDL) rotation_exact_polar_cordic_tb
wave: ghdl_rotation_exact_polar_cordic/work-obj08.cf
	ghdl -r $(GHDL) rotation_exact_polar_cordic_tb --vcd=rotation_exact_polar_cordic_tb.vcd
ghdl_rotation_exact_polar_cordic/work-obj08.cf: $(HDL)/rotation_exact_polar_cordic.vhd rotation_exact_polar_cordic_tb.vhd
	rm -rf ghdl_rotation_exact_polar_cordic
	mkdir ghdl_rotation_exact_polar_cordic
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_rotation_exact_polar_cordic rotation_exact_polar_cordic_tb.vcd
