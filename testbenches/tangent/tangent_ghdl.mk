# tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
# make -f tangent_ghdl.mk             runs the VHDL testbench
# make -f tangent_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_tangent
run: ghdl_tangent/work-obj08.cf
	ghdl -r $(GHDL) tangent_tb
wave: ghdl_tangent/work-obj08.cf
	ghdl -r $(GHDL) tangent_tb --vcd=tangent_tb.vcd
ghdl_tangent/work-obj08.cf: $(HDL)/tangent.vhd tangent_tb.vhd
	rm -rf ghdl_tangent
	mkdir ghdl_tangent
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_tangent tangent_tb.vcd
