// Compares {{ name }} with {{ reference }}, its combinational reference, which receives the
// inputs of {{ latency }} cycles ago. `differ` must stay 0 after that many cycles{% if interval > 1 %}. Results are
// compared only where they are valid: {{ latency }} cycles after accepted inputs{% endif %}.
module {{ name }}_equal (
    input  wire clk,
    input  wire valid_in,
{%- for port in inputs %}
    input  wire {{ port.shape }}port_{{ port.name }},
{%- endfor %}
    output wire differ
);
{%- if interval > 1 %}
    wire ready;
{%- endif %}
    wire [{{ input_bits }}:0] past_0 = {valid_in{% if interval > 1 %} & ready{% endif %}{% for port in inputs %}, port_{{ port.name }}{% endfor %}};
{%- for stage in range(latency) %}
    reg [{{ input_bits }}:0] past_{{ stage + 1 }};
    always @(posedge clk) past_{{ stage + 1 }} <= past_{{ stage }};
{%- endfor %}
    wire flag_old, flag_dut;
{%- for port in inputs %}
    wire {{ port.shape }}old_{{ port.name }};
{%- endfor %}
    assign {flag_old{% for port in inputs %}, old_{{ port.name }}{% endfor %}} = past_{{ latency }};
{%- for port in outputs %}
    wire {{ port.shape }}port_{{ port.name }}, reference_{{ port.name }};
{%- endfor %}
    wire flag_reference;
    {{ name }} dut (
{%- if latency > 0 %}
        .clk(clk), .rst(1'b0), .ce(1'b1),
{%- endif %}
        .valid_in(valid_in), .valid_out(flag_dut)
{%- if interval > 1 %},
        .ready(ready)
{%- endif %}
{%- for port in inputs + outputs %},
        .{{ port.name }}(port_{{ port.name }})
{%- endfor %}
    );
    {{ reference }} reference (
        .valid_in(flag_old), .valid_out(flag_reference)
{%- for port in inputs %},
        .{{ port.name }}(old_{{ port.name }})
{%- endfor %}
{%- for port in outputs %},
        .{{ port.name }}(reference_{{ port.name }})
{%- endfor %}
    );
    assign differ = flag_dut != flag_reference
{%- for port in outputs %} || {% if interval > 1 %}flag_dut && {% endif %}port_{{ port.name }} != reference_{{ port.name }}{% endfor %};
endmodule
