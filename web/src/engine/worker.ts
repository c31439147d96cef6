import init, { Engine } from "./pkg/engine.js";
import { basic, serve } from "./serve";

serve(init, () => new Engine(), basic);
