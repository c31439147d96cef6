import type { Crew } from "./crew";
import { WorkerLink } from "./link";
import { workshopModule } from "./module";

/** A worker for what a first visit does not ask: started when it is first wanted, and anew when it died. */
export interface Workshop extends Pick<Crew, "desk"> {
  /** The worker, if one was wanted. */
  opened(): Promise<WorkerLink> | null;
}

export function createWorkshop(): Workshop {
  let coming: Promise<WorkerLink> | null = null;

  async function start(): Promise<WorkerLink> {
    const link = new WorkerLink(await workshopModule(), "workshop");
    link.onDeath = close;
    await link.started;
    return link;
  }

  function close(): void {
    coming = null;
  }

  return {
    opened: () => coming,
    desk() {
      if (!coming) {
        coming = start();
        coming.catch(close);
      }
      return coming;
    },
  };
}
