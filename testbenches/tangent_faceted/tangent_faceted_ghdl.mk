# tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
# make -f tangent_faceted_ghdl.mk             runs the VHDL testbench
# make -f tangent_faceted_ghdl.mk wave        runs it and writes a VCD
# HDL=DIR says where the module is, if not here.
HDL ?= .
.PHONY: run wave clean
# A library for this module alone. It holds paths: after the folder has moved, make clean.
GHDL = --std=08 --workdir=ghdl_tangent_faceted
run: ghdl_tangent_faceted/work-obj08.cf
	ghdl -r $(GHDL) tangent_faceted_tb
wave: ghdl_tangent_faceted/work-obj08.cf
	ghdl -r $(GHDL) tangent_faceted_tb --vcd=tangent_faceted_tb.vcd
ghdl_tangent_faceted/work-obj08.cf: $(HDL)/tangent_faceted.vhd tangent_faceted_tb.vhd
	rm -rf ghdl_tangent_faceted
	mkdir ghdl_tangent_faceted
	ghdl -a $(GHDL) $^
clean:
	rm -rf ghdl_tangent_faceted tangent_faceted_tb.vcd
