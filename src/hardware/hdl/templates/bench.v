{% for line in header %}//{% if line %} {{ line }}{% endif %}
{% endfor -%}
//
// {{ name }} with its surroundings, for its testbenches. The bench has the ports of a module with
// one rate and without memories. Names in capitals belong to the bench.
{%- for rate in rates %}
// Words of rate {{ rate.name }} enter {{ entry - rate.entry }} cycle{{ "s" if entry - rate.entry != 1 }} before the sample of the fastest rate that they came with, and only
// if they differ from the previous ones.
{%- endfor %}
{%- for memory in memories %}
// Words of memory {{ memory.title }} come from {{ memory.file }}{{ "; they are written during the reset" if memory.write }}.
{%- endfor %}
module {{ top }} (
    input  wire clk,
    input  wire rst,
    input  wire ce,
    input  wire valid_in,
{%- if interval > 1 %}
    output wire ready,
{%- endif %}
{%- for port in inputs %}
    input  wire {{ port.shape }}{{ port.name }},
{%- endfor %}
    output wire valid_out
{%- for port in outputs -%}
    ,
    output wire {{ port.shape }}{{ port.name }}
{%- endfor %}
);
    wire TAKEN = valid_in{{ " & ready" if interval > 1 }};
{%- for rate in rates %}

    // Words of rate {{ rate.name }} and of slower rates.
    wire [{{ rate.bits - 1 }}:0] WORDS_{{ rate.name }} = { {%- for name in rate.ports %}{{ name }}{{ ", " if not loop.last }}{% endfor -%} };
    reg [{{ rate.bits - 1 }}:0] LAST_{{ rate.name }};
    reg KNOWN_{{ rate.name }};
    always @(posedge clk)
        if (rst) KNOWN_{{ rate.name }} <= 1'b0;
        else if (ce & TAKEN) KNOWN_{{ rate.name }} <= 1'b1;
    always @(posedge clk)
        if (ce & TAKEN) LAST_{{ rate.name }} <= WORDS_{{ rate.name }};
    wire VALID_{{ rate.name }}_0 = TAKEN & ~(KNOWN_{{ rate.name }} && LAST_{{ rate.name }} == WORDS_{{ rate.name }});
{%- for stage in range(rate.entry) %}
    reg VALID_{{ rate.name }}_{{ stage + 1 }};
    always @(posedge clk)
        if (rst) VALID_{{ rate.name }}_{{ stage + 1 }} <= 1'b0;
        else if (ce) VALID_{{ rate.name }}_{{ stage + 1 }} <= VALID_{{ rate.name }}_{{ stage }};
{%- endfor %}
{%- endfor %}
{%- if entry > 0 %}

    // Delays for rates that enter later.
    wire VALID_0 = TAKEN;
{%- for stage in range(entry) %}
    reg VALID_{{ stage + 1 }};
    always @(posedge clk)
        if (rst) VALID_{{ stage + 1 }} <= 1'b0;
        else if (ce) VALID_{{ stage + 1 }} <= VALID_{{ stage }};
{%- endfor %}
{%- for port in inputs if port.entry > 0 %}
    wire [{{ port.bits - 1 }}:0] LATE_{{ port.name }}_0 = {{ port.name }};
{%- for stage in range(port.entry) %}
    reg [{{ port.bits - 1 }}:0] LATE_{{ port.name }}_{{ stage + 1 }};
    always @(posedge clk) if (ce) LATE_{{ port.name }}_{{ stage + 1 }} <= LATE_{{ port.name }}_{{ stage }};
{%- endfor %}
{%- endfor %}
{%- endif %}
{%- for memory in memories %}

    reg [{{ memory.row_bits - 1 }}:0] ROWS_{{ memory.title }} [0:{{ memory.last }}];
    initial $readmemh("{{ memory.file }}", ROWS_{{ memory.title }});
{%- if memory.write %}
    reg [{{ memory.addr_bits - 1 }}:0] LOAD_{{ memory.title }};
    initial LOAD_{{ memory.title }} = {{ memory.addr_bits }}'d0;
    always @(posedge clk) if (rst) LOAD_{{ memory.title }} <= LOAD_{{ memory.title }} + {{ memory.addr_bits }}'d1;
    wire [{{ memory.row_bits - 1 }}:0] ROW_{{ memory.title }} = ROWS_{{ memory.title }}[LOAD_{{ memory.title }}];
{%- endif %}
{%- for read in memory.reads %}
    wire [{{ memory.addr_bits - 1 }}:0] ADDRESS_{{ read.address }};
{%- for cycle in range(memory.latency) %}
    reg [{{ memory.row_bits - 1 }}:0] ROW_{{ read.address }}_{{ cycle + 1 }};
{%- if cycle == 0 %}
    always @(posedge clk) if (ce) ROW_{{ read.address }}_1 <= ROWS_{{ memory.title }}[ADDRESS_{{ read.address }}];
{%- else %}
    always @(posedge clk) if (ce) ROW_{{ read.address }}_{{ cycle + 1 }} <= ROW_{{ read.address }}_{{ cycle }};
{%- endif %}
{%- endfor %}
{%- endfor %}
{%- endfor %}
{%- for rate in rates if rate.ready and not rate.is_all %}
    wire READY_unused_{{ rate.name }};
{%- endfor %}
{%- if unit_interval > 1 and unit_interval < interval %}
    wire READY_unused;
{%- endif %}

    {{ name }} DUT (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in({{ "VALID_" ~ entry if entry > 0 else "TAKEN" }}), .valid_out(valid_out)
{%- for rate in rates %},
        .{{ rate.port }}(VALID_{{ rate.name }}_{{ rate.entry }})
{%- if rate.ready %},
        .{{ rate.ready }}({{ "ready" if rate.is_all else "READY_unused_" ~ rate.name }})
{%- endif %}
{%- endfor %}
{%- if unit_interval > 1 %},
        .ready({{ "ready" if unit_interval == interval else "READY_unused" }})
{%- endif %}
{%- for port in inputs -%}
        ,
        .{{ port.name }}({{ "LATE_" ~ port.name ~ "_" ~ port.entry if port.entry > 0 else port.name }})
{%- endfor %}
{%- for port in outputs -%}
        ,
        .{{ port.name }}({{ port.name }})
{%- endfor %}
{%- for memory in memories %}
{%- for read in memory.reads -%}
        ,
        .{{ read.address }}(ADDRESS_{{ read.address }})
{%- for data in read.data -%}
        ,
        .{{ data.name }}(ROW_{{ read.address }}_{{ memory.latency }}{{ data.slice if memory.row_bits > 1 }})
{%- endfor %}
{%- endfor %}
{%- if memory.write -%}
        ,
        .{{ memory.write.enable }}(rst), .{{ memory.write.address }}(LOAD_{{ memory.title }})
{%- for data in memory.write.data -%}
        ,
        .{{ data.name }}(ROW_{{ memory.title }}{{ data.slice if memory.row_bits > 1 }})
{%- endfor %}
{%- endif %}
{%- endfor %}
    );
endmodule
