#include "definitions.hpp"

namespace isostretch::scene {
namespace {

// Readers take the keys of objects from here, so that no key is known to one and not to the other.
constexpr const char* definitions_json = R"json({
  "point": {
    "description": "Coordinates, two in the plane and three in space",
    "type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 3
  },
  "count": {"type": "integer", "minimum": 1},
  "positive": {"type": "number", "exclusiveMinimum": 0},
  "bar": {
    "description": "A box of elements from the origin to size; with two numbers each a rectangle",
    "type": "object", "additionalProperties": false, "required": ["cells"],
    "properties": {
      "cells": {"type": "array", "items": {"$ref": "#/$defs/count"}, "minItems": 2, "maxItems": 3},
      "size": {"type": "array", "items": {"$ref": "#/$defs/positive"}, "minItems": 2, "maxItems": 3},
      "element": {"enum": ["triangle", "quadratic_triangle", "quad", "tet", "quadratic_tet", "hex"]}
    }
  },
  "grid": {
    "description": "A rectangle of cells, each cut into two triangles or, crossed, into four",
    "type": "object", "additionalProperties": false, "required": ["cells"],
    "properties": {
      "cells": {"type": "array", "items": {"$ref": "#/$defs/count"}, "minItems": 2, "maxItems": 2},
      "size": {"type": "array", "items": {"$ref": "#/$defs/positive"}, "minItems": 2, "maxItems": 2},
      "split": {"enum": ["crossed", "two"], "default": "crossed"}
    }
  },
  "disc": {
    "description": "The unit disc",
    "type": "object", "additionalProperties": false, "required": ["rings"],
    "properties": {"rings": {"$ref": "#/$defs/count"}}
  },
  "ball": {
    "description": "The unit ball, so many cells across",
    "type": "object", "additionalProperties": false, "required": ["cells"],
    "properties": {"cells": {"$ref": "#/$defs/count"}}
  },
  "quadruped": {
    "description": "An animal on four legs from x = 0 to 1, so many cells long",
    "type": "object", "additionalProperties": false, "required": ["cells"],
    "properties": {"cells": {"$ref": "#/$defs/count"}}
  },
  "photo_grid": {
    "description": "A crossed grid over the photo with so many cells along its longer side, which has length 1",
    "type": "object", "additionalProperties": false, "required": ["cells"],
    "properties": {"cells": {"$ref": "#/$defs/count"}}
  },
  "generated": {
    "description": "A body that is made, by one of these",
    "type": "object", "additionalProperties": false, "minProperties": 1, "maxProperties": 1,
    "properties": {
      "bar": {"$ref": "#/$defs/bar"}, "grid": {"$ref": "#/$defs/grid"}, "disc": {"$ref": "#/$defs/disc"},
      "ball": {"$ref": "#/$defs/ball"}, "quadruped": {"$ref": "#/$defs/quadruped"},
      "photo_grid": {"$ref": "#/$defs/photo_grid"}
    }
  },
  "mesh": {
    "description": "A file, sought from the folder of the scene, or a body that is made",
    "anyOf": [{"type": "string"}, {"$ref": "#/$defs/generated"}]
  },
  "energy": {
    "description": "Name or expression of an energy, with its parameters",
    "type": "object", "additionalProperties": false, "required": ["name"],
    "properties": {
      "name": {"type": "string"},
      "parameters": {"type": "object", "additionalProperties": {"type": "number"}}
    }
  },
  "energy_choice": {
    "description": "Distortion energy: a name, an expression in I1, I2, I3, or either with parameters",
    "anyOf": [{"type": "string"}, {"$ref": "#/$defs/energy"}]
  },
  "material": {
    "description": "Stiffness: Young's modulus and Poisson's ratio, or Lame's parameters",
    "type": "object", "additionalProperties": false,
    "properties": {
      "young": {"$ref": "#/$defs/positive"},
      "poisson": {"type": "number", "exclusiveMinimum": -1, "exclusiveMaximum": 0.5},
      "mu": {"type": "number"},
      "lambda": {"type": "number"}
    }
  },
  "region": {
    "description": "Elements with an energy or a material of their own",
    "type": "object", "additionalProperties": false,
    "properties": {
      "name": {"type": "string"},
      "select": {"$ref": "#/$defs/selection_choice"},
      "elements": {"type": "array", "items": {"type": "integer", "minimum": 0}},
      "energy": {"$ref": "#/$defs/energy_choice"},
      "material": {"$ref": "#/$defs/material"}
    }
  },
  "box": {
    "description": "Vertices between two corners",
    "type": "object", "additionalProperties": false, "required": ["min", "max"],
    "properties": {"min": {"$ref": "#/$defs/point"}, "max": {"$ref": "#/$defs/point"}}
  },
  "sphere": {
    "description": "Vertices in a ball",
    "type": "object", "additionalProperties": false, "required": ["center", "radius"],
    "properties": {"center": {"$ref": "#/$defs/point"}, "radius": {"$ref": "#/$defs/positive"}}
  },
  "segment": {
    "description": "Vertices near a straight line, a bone",
    "type": "object", "additionalProperties": false, "required": ["from", "to", "distance"],
    "properties": {
      "from": {"$ref": "#/$defs/point"}, "to": {"$ref": "#/$defs/point"},
      "distance": {"$ref": "#/$defs/positive"}
    }
  },
  "slab": {
    "description": "One end of the body along an axis: a fraction of its extent, or a width",
    "type": "object", "additionalProperties": false, "required": ["axis", "end"],
    "properties": {
      "axis": {"enum": ["x", "y", "z"]}, "end": {"enum": ["min", "max"]},
      "fraction": {"$ref": "#/$defs/positive"}, "width": {"$ref": "#/$defs/positive"}
    }
  },
  "nearest": {
    "description": "The vertices nearest to a point",
    "type": "object", "additionalProperties": false, "required": ["point"],
    "properties": {"point": {"$ref": "#/$defs/point"}, "count": {"$ref": "#/$defs/count"}}
  },
  "patch": {
    "description": "Vertices of the boundary within a distance along it of the one nearest to a point",
    "type": "object", "additionalProperties": false, "required": ["point", "distance"],
    "properties": {"point": {"$ref": "#/$defs/point"}, "distance": {"$ref": "#/$defs/positive"}}
  },
  "selection": {
    "description": "Vertices, by one of these",
    "type": "object", "additionalProperties": false, "minProperties": 1, "maxProperties": 1,
    "properties": {
      "box": {"$ref": "#/$defs/box"}, "sphere": {"$ref": "#/$defs/sphere"},
      "segment": {"$ref": "#/$defs/segment"},
      "vertices": {"type": "array", "items": {"type": "integer", "minimum": 0}},
      "slab": {"$ref": "#/$defs/slab"}, "nearest": {"$ref": "#/$defs/nearest"},
      "patch": {"$ref": "#/$defs/patch"},
      "group": {"description": "A group of the file, by name or number", "type": ["string", "integer"]}
    }
  },
  "selection_choice": {"anyOf": [{"const": "all"}, {"$ref": "#/$defs/selection"}]},
  "rotation": {
    "description": "A turn; the axis is left out in the plane",
    "type": "object", "additionalProperties": false, "required": ["degrees"],
    "properties": {"axis": {"$ref": "#/$defs/point"}, "degrees": {"type": "number"}}
  },
  "keyframe": {
    "description": "Where a handle is at a time",
    "type": "object", "additionalProperties": false, "required": ["time"],
    "properties": {
      "time": {"type": "number"}, "translate": {"$ref": "#/$defs/point"},
      "rotate": {"$ref": "#/$defs/rotation"}, "scale": {"$ref": "#/$defs/positive"}
    }
  },
  "handle": {
    "description": "A part of the body and how it moves; without a motion it is held where it is",
    "type": "object", "additionalProperties": false, "required": ["select"],
    "properties": {
      "name": {"description": "What reports call it", "type": "string"},
      "select": {"$ref": "#/$defs/selection_choice"},
      "translate": {"$ref": "#/$defs/point"}, "rotate": {"$ref": "#/$defs/rotation"},
      "scale": {"$ref": "#/$defs/positive"},
      "center": {"description": "Centre of turning and growing; otherwise the mean of its vertices",
                 "$ref": "#/$defs/point"},
      "keyframes": {"type": "array", "items": {"$ref": "#/$defs/keyframe"}, "minItems": 1},
      "soft": {"description": "Weight of a handle that is held softly", "$ref": "#/$defs/positive"},
      "hard": {"description": "The handle is held exactly", "type": "boolean"}
    }
  },
  "photo": {
    "description": "A picture (PNG) and how it lies on the mesh: filling its box, or one unit a pixel",
    "type": "object", "additionalProperties": false, "required": ["file"],
    "properties": {"file": {"type": "string"}, "fit": {"enum": ["box", "pixels"], "default": "box"}}
  },
  "pin": {
    "description": "A vertex of the model, counted from 0, that is held: where the start has it, at a place, or softly",
    "type": "object", "additionalProperties": false, "required": ["vertex"],
    "properties": {
      "vertex": {"type": "integer", "minimum": 0}, "target": {"$ref": "#/$defs/point"},
      "soft": {"description": "Weight of a vertex that is drawn to its target", "$ref": "#/$defs/positive"}
    }
  },
  "aligned": {
    "description": "Vertices of the model that come to lie on a line along an axis",
    "type": "object", "additionalProperties": false, "required": ["vertices", "line"],
    "properties": {
      "vertices": {"type": "array", "items": {"type": "integer", "minimum": 0}, "minItems": 2},
      "line": {"enum": ["horizontal", "vertical"]}
    }
  },
  "problem": {
    "description": "A surface to flatten or a body to deform; handles are all hard",
    "type": "object", "additionalProperties": false, "required": ["name", "mesh", "energy"],
    "properties": {
      "name": {"description": "Names the folder of its results", "type": "string"},
      "mesh": {"anyOf": [{"$ref": "#/$defs/mesh"}, {"$ref": "#/$defs/face"}]},
      "energy": {"$ref": "#/$defs/energy_choice"}, "material": {"$ref": "#/$defs/material"},
      "handles": {"type": "array", "items": {"$ref": "#/$defs/handle"}},
      "initial_guess": {"enum": ["rest", "previous", "harmonic", "biharmonic"]},
      "order": {"type": "integer", "minimum": 1, "maximum": 2},
      "quadrature": {"type": "integer", "minimum": 1, "maximum": 5}
    }
  },
  "face": {
    "description": "A face, a surface that is made for comparisons",
    "type": "object", "additionalProperties": false, "required": ["face"],
    "properties": {
      "face": {
        "type": "object", "additionalProperties": false, "required": ["rings"],
        "properties": {"rings": {"$ref": "#/$defs/count"}}
      }
    }
  },
  "scene": {
    "$schema": "https://json-schema.org/draft/2020-12/schema",
    "title": "Scene of isostretch",
    "description": "Input of all isostretch apps; each takes the keys that it knows what to do with",
    "type": "object", "additionalProperties": false,
    "properties": {
      "schema": {"description": "Version of this schema", "const": 1},
      "mesh": {"$ref": "#/$defs/mesh"},
      "second_mesh": {"description": "File of the second shape (isostretch-interpolate)", "type": "string"},
      "order": {
        "description": "2 makes quadratic elements of the linear ones in the file",
        "type": "integer", "minimum": 1, "maximum": 2
      },
      "quadrature": {
        "description": "Degree of the polynomials that are integrated exactly over an element",
        "type": "integer", "minimum": 1, "maximum": 5
      },
      "energy": {"$ref": "#/$defs/energy_choice"},
      "material": {"$ref": "#/$defs/material"},
      "regions": {"type": "array", "items": {"$ref": "#/$defs/region"}},
      "handles": {"type": "array", "items": {"$ref": "#/$defs/handle"}, "minItems": 1},
      "frames": {
        "description": "Steps from rest, or from the first shape, to the end of the motion",
        "type": "integer", "minimum": 1, "maximum": 1000000
      },
      "initial_guess": {
        "description": "Shape that the solver starts every frame from (isostretch-deform)",
        "enum": ["rest", "previous", "harmonic", "biharmonic"], "default": "biharmonic"
      },
      "newton": {"description": "How the energy is minimised"},
      "manipulation": {"description": "How a body is manipulated (isostretch-manipulate)"},
      "rival": {
        "description": "Name of a rival that solves in the place of the method (isostretch-manipulate)",
        "type": "string"
      },
      "interpolation": {"description": "How shapes between two are made (isostretch-interpolate)"},
      "parameterization": {"description": "How a surface is flattened (isostretch-parameterize)"},
      "format": {"description": "File format of the frames", "enum": ["vtu", "obj", "msh"], "default": "vtu"},
      "up": {"description": "What is up in pictures; otherwise guessed", "enum": ["x", "y", "z"]},
      "photo": {"anyOf": [{"type": "string"}, {"$ref": "#/$defs/photo"}]},
      "problems": {
        "description": "What methods are compared on (isostretch-compare)",
        "type": "array", "items": {"$ref": "#/$defs/problem"}, "minItems": 1
      },
      "methods": {"description": "Names of the methods", "type": "array", "items": {"type": "string"}},
      "limits": {"description": "What every run of a comparison is allowed"},
      "repetitions": {
        "description": "Runs of each method on each problem; the median counts",
        "type": "integer", "minimum": 1, "maximum": 1000, "default": 3
      }
    }
  }
})json";

}  // namespace

const Value& definitions() {
  static const Value all = parse_json(definitions_json, "definitions of scenes");
  return all;
}

std::vector<std::string> keys_of(const std::string& definition) {
  std::vector<std::string> keys;
  for (const Member& member : definitions().find(definition)->find("properties")->members())
    keys.push_back(member.key);
  return keys;
}

}  // namespace isostretch::scene
