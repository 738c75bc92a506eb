# bench: curves on logarithmic axes, as SVG.
import math
from dataclasses import dataclass

COLORS = ['#1f6fb4', '#d1495b', '#2e8b57', '#8a5fbf', '#c77d0a', '#4a4a4a']
WIDTH, HEIGHT = 460, 300
LEFT, RIGHT, TOP, BOTTOM = 62, 14, 34, 44


@dataclass
class Curve:
    label: str
    points: list  # of (x, y), both above 0
    dashed: bool = False


def decades(low, high):
    return range(math.floor(math.log10(low) + 1e-9), math.ceil(math.log10(high) - 1e-9) + 1)


def power_text(exponent):
    if -3 <= exponent <= 3:
        return f'{10.0 ** exponent:g}'
    return f'10<tspan dy="-5" font-size="9">{exponent}</tspan>'


def panel(title, x_label, y_label, curves, left, limits=()):
    """One pair of axes; `limits` are horizontal lines with a name: (y, text)."""
    xs = [x for c in curves for x, _ in c.points]
    ys = [y for c in curves for _, y in c.points] + [y for y, _ in limits]
    x_range, y_range = decades(min(xs), max(xs)), decades(min(ys), max(ys))
    x0, y0 = left + LEFT, HEIGHT - BOTTOM
    width, height = WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM

    def at_x(x):
        return x0 + width * (math.log10(x) - x_range[0]) / max(1, x_range[-1] - x_range[0])

    def at_y(y):
        return y0 - height * (math.log10(y) - y_range[0]) / max(1, y_range[-1] - y_range[0])

    out = [f'<text x="{left + 10}" y="18" font-size="13" font-weight="bold">{title}</text>']
    for e in x_range:
        x = at_x(10.0 ** e)
        out.append(f'<path d="M{x:.1f} {TOP}V{y0}" stroke="#ddd"/>')
        out.append(f'<text x="{x:.1f}" y="{y0 + 16}" text-anchor="middle">{power_text(e)}</text>')
    for e in y_range:
        y = at_y(10.0 ** e)
        out.append(f'<path d="M{x0} {y:.1f}H{x0 + width}" stroke="#ddd"/>')
        out.append(f'<text x="{x0 - 6}" y="{y + 4:.1f}" text-anchor="end">{power_text(e)}</text>')
    for y, text in limits:
        out.append(f'<path d="M{x0} {at_y(y):.1f}H{x0 + width}" stroke="#999" '
                   'stroke-dasharray="2 3"/>')
        out.append(f'<text x="{x0 + width - 4}" y="{at_y(y) - 4:.1f}" text-anchor="end" '
                   f'fill="#777">{text}</text>')
    longest = max(len(curve.label) for curve in curves)
    out.append(f'<rect x="{x0 + 6}" y="{TOP + 2}" width="{34 + 6 * longest}" '
               f'height="{15 * len(curves) + 4}" fill="white"/>')
    for k, curve in enumerate(curves):
        color = COLORS[k % len(COLORS)]
        line = ' '.join(f'{at_x(x):.1f},{at_y(y):.1f}' for x, y in curve.points)
        dash = ' stroke-dasharray="5 3"' if curve.dashed else ''
        out.append(f'<polyline points="{line}" fill="none" stroke="{color}" stroke-width="1.8"'
                   f'{dash}/>')
        out += [f'<circle cx="{at_x(x):.1f}" cy="{at_y(y):.1f}" r="2.4" fill="{color}"/>'
                for x, y in curve.points]
        row = TOP + 14 + 15 * k
        out.append(f'<path d="M{x0 + 10} {row - 4}h18" stroke="{color}" stroke-width="1.8"{dash}/>')
        out.append(f'<text x="{x0 + 33}" y="{row}">{curve.label}</text>')
    out.append(f'<text x="{x0 + width / 2}" y="{HEIGHT - 8}" text-anchor="middle">{x_label}</text>')
    middle = TOP + height / 2
    out.append(f'<text x="{left + 14}" y="{middle}" text-anchor="middle" '
               f'transform="rotate(-90 {left + 14} {middle})">{y_label}</text>')
    return out


def chart(panels):
    """Panels side by side, each the arguments of panel() but `left`, as the text of an SVG file."""
    width = WIDTH * len(panels)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{HEIGHT}" '
           f'viewBox="0 0 {width} {HEIGHT}" font-family="sans-serif" font-size="11">',
           '<rect width="100%" height="100%" fill="white"/>']
    for k, one in enumerate(panels):
        out += panel(left=k * WIDTH, **one)
    return '\n'.join(out + ['</svg>', ''])
