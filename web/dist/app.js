(function(){var e=class extends Error{};function t(t,n){if(!t)throw new e(`The description of the light field is damaged: ${n}.`)}var n=e=>typeof e==`number`&&Number.isFinite(e),r=(e,t)=>Array.isArray(e)&&e.length===t&&e.every(n),i=e=>r(e,2)&&e.every(e=>e>=1&&e<=65536&&Number.isInteger(e)),a=e=>Array.isArray(e)&&e.length<=8&&e.every(e=>typeof e?.name==`string`&&typeof e.missed==`boolean`);function o(e,r){t(typeof e==`object`&&!!e,`it has no "${r}"`),t(Number.isInteger(e.views)&&e.views>=1&&e.views<=65536,`"${r}" has no number of views`),t(n(e.first)&&n(e.step),`"${r}" does not say where the views are`)}function s(e){t(typeof e==`object`&&!!e,`it is no object`),t(i(e.view_size)&&i(e.tiles),`it does not say how large views are`),o(e.across,`across`),o(e.up,`up`),t(e.tiles[0]*e.tiles[1]>=e.across.views*e.up.views,`it has fewer tiles than views`),t(n(e.vergence_per_mm)&&n(e.disparity_scale_mm),`it does not say the viewing distance`),t(r(e.window_mm?.centre,2)&&r(e.window_mm?.size,2),`it has no window`),t(r(e.eye_mm,3)&&e.eye_mm[2]>0,`it has no eye`),t(Array.isArray(e.lens_samples)&&i(e.panel?.size),`it does not say what the panel shows`),e.provenance??=null,t(e.provenance===null||a(e.provenance),`it does not say what the codes of provenance are`),t(n(e.frames_per_second)&&e.frames_per_second>0,`it has no frame rate`),t(Array.isArray(e.frames)&&e.frames.length>0,`it has no frames`),t(e.frames.every(e=>typeof e?.label==`string`),`a frame has no label`)}function c(e){let n=e?.fields;return t(Array.isArray(n)&&n.length>0,`it lists no light field`),n.forEach(s),n}var l=(e,t)=>e.by===`angle`?Math.atan(t):t,u=(e,t)=>e.by===`angle`?Math.tan(t):t,d=(e,t)=>u(e,e.first+e.step*(t*e.views-.5)),f=(e,t)=>e.step===0?.5:((l(e,t)-e.first)/e.step+.5)/e.views,p=(e,t)=>t/(1-t*e.vergence_per_mm),ee=(e,t)=>t/(1+t*e.vergence_per_mm),te=e=>e.panel.is!==`own`&&e.across.views*e.up.views>1;function ne(e){let t=1/(1+.3275911*e);return 1-t*(.254829592+t*(-.284496736+t*(1.421413741+t*(-1.453152027+t*1.061405429))))*Math.exp(-e*e)}var re=e=>e>0?.5*(ne(1.5/(Math.SQRT2*e))-ne(.5/(Math.SQRT2*e))):0;function ie(e,t){let n=(n,r,i)=>{if(n.views<2||n.step===0)return!1;let a=e.window_mm.centre[r]+((i+.5)/128-.5)*e.window_mm.size[r],o=f(n,t[r]/t[2]-a*(1/t[2]-e.vergence_per_mm));return o<0||o>1},r=[...Array(128).keys()],[i,a]=[0,1].map(t=>r.filter(r=>n(t===0?e.across:e.up,t,r)).length/128);return 1-(1-i)*(1-a)}function m(e){let[t,n]=e.window_mm.size,r=Math.min(t/e.view_size[0],n/e.view_size[1]);return[Math.max(1,Math.round(t/r)),Math.max(1,Math.round(n/r))]}var h=()=>document.querySelector(`meta[name="lippmann-data"]`)?.getAttribute(`content`)===`scripts`;function ae(t){return new Promise((n,r)=>{let i=document.createElement(`script`);i.src=t,i.onload=()=>(i.remove(),n()),i.onerror=()=>(i.remove(),r(new e(`${t} is missing or cannot be read.`))),document.head.append(i)})}async function oe(e,t){try{return await fetch(e,t)}catch(n){if(e===`live/render`)throw n;return fetch(e,t)}}async function g(t,n={}){let r;try{r=await oe(t,n)}catch{throw new e(`The server does not answer: has the program been ended?`)}if(r.ok)return r;let i=await r.text(),a=i.trim();try{a=JSON.parse(i).error}catch{}throw new e(a||`${t}: the server answers ${r.status}.`)}async function se(e,t){await g(e,{method:`POST`,body:t,headers:{"Content-Type":`application/octet-stream`}})}async function _(t,n){if(h())throw new e("A saved page cannot read calibrations: `lippmann play` does.");return(await g(t,{method:`POST`,body:n,headers:{"Content-Type":`text/plain`}})).text()}var v=e=>!h()&&e.panel.is===`own`&&e.across.views*e.up.views>1,ce=async e=>(await g(e)).json();async function le(){if(!h()){let t=await(await g(`fields.json`)).text();try{return JSON.parse(t)}catch{throw new e(`The description of the light field is damaged: it is no JSON.`)}}let t;if(window.lippmann_fields=e=>t=e,await ae(`fields.js`),t===void 0)throw new e(`fields.js is damaged: it describes no light field.`);return t}var y=new Map;function ue(e,t){let n=atob(e),r=new Uint8Array(n.length);for(let e=0;e<n.length;e++)r[e]=n.charCodeAt(e);return new Blob([r],{type:t})}function de(t,n,r){let i=y.get(t);y.delete(t);try{i?.resolve(ue(r,n))}catch{i?.reject(new e(`${t}.js is damaged.`))}}function fe(t){return window.lippmann_data??=de,new Promise((n,r)=>{y.set(t,{resolve:n,reject:r}),ae(`${t}.js`).then(()=>{y.delete(t)&&r(new e(`${t}.js is damaged: it holds no picture.`))},r)})}async function b(e){return h()?fe(e):(await g(e)).blob()}function x(e,t={},...n){let r=Object.assign(document.createElement(e),t);return r.append(...n),r}var S=(e,t)=>e.toFixed(t).replace(/^-0(\.0*)?$/,`0$1`).replace(`-`,`−`),C=0;function w(e,t){let n=`control-${C++}`,r=x(`input`,{type:`range`,id:n}),i=e.text??(t=>`${S(t,1)}${e.unit?`\u2009${e.unit}`:``}`),a=x(`output`,{className:`value`});a.setAttribute(`for`,n),r.addEventListener(`input`,()=>e.late?.()?a.value=i(Number(r.value)):e.set(Number(r.value))),r.addEventListener(`change`,()=>e.late?.()&&e.set(Number(r.value))),e.reset&&r.addEventListener(`dblclick`,e.reset);let o=x(`div`,{className:`row`},x(`label`,{htmlFor:n},e.label),a,r);return t.push({update:()=>{o.hidden=e.applies!==void 0&&!e.applies();let[t,n]=e.range();r.min=String(t),r.max=String(n),r.step=String((n-t)/(e.steps??200)||`any`);let s=e.value();(document.activeElement!==r||Math.abs(Number(r.value)-s)>Number(r.step))&&(r.value=String(s)),a.value=i(s),r.setAttribute(`aria-valuetext`,a.value)}}),o}function T(e,t,n,r,i,a=()=>!0){let o=`control-${C++}`,s=x(`select`,{id:o});s.addEventListener(`change`,()=>r(s.value));let c=x(`div`,{className:`row choice`},x(`label`,{htmlFor:o},e),s),l=``;return i.push({update:()=>{c.hidden=!a();let e=t();JSON.stringify(e)!==l&&s.replaceChildren(...e.map(([e,t])=>x(`option`,{value:e},t))),l=JSON.stringify(e),s.value=n()}}),c}function pe(e,t){let n=`control-${C++}`,r=x(`input`,{type:`text`,id:n,inputMode:e.numeric?`decimal`:`text`,autocomplete:`off`,spellcheck:!1}),i=x(`div`,{className:`row entry`},x(`label`,{htmlFor:n},e.label),r);return e.choices&&(r.setAttribute(`list`,`${n}-choices`),i.append(x(`datalist`,{id:`${n}-choices`},...e.choices.map(e=>x(`option`,{value:e}))))),r.addEventListener(`change`,()=>e.set(r.value.trim())),t.push({update:()=>{i.hidden=!e.applies(),document.activeElement!==r&&(r.value=e.value())}}),i}function E(e,t,n,r,i=()=>!0){let a=`control-${C++}`,o=x(`input`,{type:`checkbox`,id:a});o.addEventListener(`change`,()=>n(o.checked));let s=x(`div`,{className:`row check`},o,x(`label`,{htmlFor:a},e));return r.push({update:()=>{s.hidden=!i(),o.checked=t()}}),s}function D(e,...t){let n=t.filter(e=>e!==null),r=`group-${C++}`,i=x(`section`,{},x(`h2`,{id:r},e),...n);return i.setAttribute(`aria-labelledby`,r),i}function O(e,t){let n=x(`button`,{type:`button`},e);return n.addEventListener(`click`,t),n}var k=e=>new Promise(t=>window.setTimeout(t,e)),me=500,he=e=>e<90?`${Math.ceil(e)} s`:`${Math.ceil(e/60)} min`,ge=class{constructor(e,t,n,r){this.state=e,this.field=t,this.changed=n,this.notify=r,this.known=0,this.listening=!1,this.asking=null;for(let e of t.frames)e.pending=!0;this.take(e.finished),this.listen()}get isUnderWay(){return this.state.state===`running`||this.state.state===`starting`}get canResume(){return this.state.state===`stopped`}describe(){let{state:e,done:t,frames:n,seconds_left:r,host:i}=this.state,a=`${t} of ${n} frame${n===1?``:`s`}`;return e===`running`?`Rendering: ${a}${r===null?``:`, about ${he(r)} left`}`:e===`starting`?`Being set up: ${a}`:e===`stopping`?`Stopping: ${a}`:e===`elsewhere`?`${a}. ${i} renders the others, or was stopped.`:e===`stopped`?`Stopped: ${a}`:`Finished: ${n} frame${n===1?``:`s`}`}async toggle(){let e=this.isUnderWay?`stop`:this.canResume?`resume`:``;if(e)try{await _(`run/${e}`,`{}`),this.notify(`asked`,``),await this.ask(),e===`resume`&&this.listen()}catch(e){this.notify(`asked`,e instanceof Error?e.message:String(e))}}take(e){this.known+=e.length;for(let{index:t,kind:n,psnr_db:r}of e)Object.assign(this.field.frames[t],{pending:!1,kind:n,psnr_db:r})}ask(){return this.asking??=this.answer().finally(()=>this.asking=null),this.asking}async answer(){let e=JSON.stringify({...this.state,finished:[]}),t=await ce(`run/state/${this.known}`);this.state=t,this.take(t.finished),(t.finished.length>0||JSON.stringify({...t,finished:[]})!==e)&&this.changed(t.finished)}async listen(){if(!this.listening){for(this.listening=!0;this.state.state!==`finished`;){await k(me);try{await this.ask(),this.notify(`server`,``)}catch(e){this.notify(`server`,e instanceof Error?e.message:String(e)),await k(2e3)}}this.listening=!1}}},_e={lenticular:`Lenticular sheet`,microlens:`Microlens array`,multiview:`Views of a quilt`,single:`One view`,whitted:`Direct light (Whitted)`,path:`Paths, all light`,none:`None`,neutral:`Neutral`,agx:`AgX`},A=e=>[e,_e[e]??e],j=(e,t=3)=>String(Number(e.toPrecision(t)));function M(e){let[t,n]=e.value(`orbit`).split(`,`).map(Number);return[Number.isFinite(t)?t:0,Number.isFinite(n)?n:0]}function N(e,t,n){let r=((t+180)%360+360)%360-180;e.set({orbit:`${S(r,1)},${S(Math.min(Math.max(n,-89),89),1)}`.replace(/\u2212/g,`-`)})}function ve(e,t){e.set({zoom:j(Math.min(Math.max(t,.1),20))})}function ye(e){let t=e.state?.plane;if(!t)return[0,1];let n=Math.max(t.farthest-t.nearest,.02*t.distance),r=P(e);return[Math.min(Math.max(t.nearest-.25*n,.05*t.distance),r),Math.max(t.farthest+.25*n,r)]}var P=e=>e.pendingNumber(`focus`)??e.state?.plane?.distance??1;function be(e,t){e.set({focus:j(t,5)})}function xe(e){let{across:t}=e,n=t.first+t.step*(t.views-.5),r=t.first-.5*t.step,i=e=>t.by===`angle`?e:Math.atan(e);return Math.abs((i(n)-i(r))*180/Math.PI)}function Se(e,t,n){let{state:r}=e;return D(`Set-up`,T(`Dragging the picture`,()=>[[`eye`,`Moves the eye`],[`turn`,`Turns the camera; the wheel zooms`],[`plane`,`Moves the plane; a click puts it there`]],()=>r.drag,t=>e.set({drag:t}),n),w({label:`Turn`,range:()=>[-180,180],steps:360,value:()=>M(t)[0],text:e=>`${S(e,1)}\u00b0`,set:e=>N(t,e,M(t)[1]),reset:()=>t.set({orbit:null})},n),w({label:`Raise`,range:()=>[-89,89],steps:178,value:()=>M(t)[1],text:e=>`${S(e,1)}\u00b0`,set:e=>N(t,M(t)[0],e),reset:()=>t.set({orbit:null})},n),w({label:`Zoom`,range:()=>[-2,4],steps:120,value:()=>Math.log2(t.number(`zoom`,1)),text:()=>`${j(t.number(`zoom`,1))}\u00d7`,set:e=>ve(t,2**e),reset:()=>t.set({zoom:null})},n),w({label:`Display plane, from the viewer`,applies:()=>!!t.state?.plane,range:()=>ye(t),value:()=>P(t),text:e=>j(e,4),set:e=>be(t,e),reset:()=>t.set({focus:null})},n),E(`Fit the depth to the display`,()=>t.value(`fit-depth`)===`true`||t.value(`fit-depth`)===``&&Ce(t),e=>t.set({"fit-depth":String(e)}),n),E(`Show the depth budget`,()=>r.budget,t=>e.set({budget:t}),n,()=>e.fields[0].depth))}var Ce=e=>e.value(`display`)!==``||e.value(`optics`)!==`multiview`;function we(e,t,n){let r=t.about.choices.display??[];return D(`Display`,T(`Display`,()=>{let e=t.value(`display`);return[[``,`None: lenses as set here`],...[...e===``||r.includes(e)?[]:[e],...r].map(e=>[e,e.split(`/`).pop()??e])]},()=>t.value(`display`),e=>t.set({display:e,optics:null,"view-angle":null}),n),T(`Optics`,()=>(t.about.choices.optics??[]).map(A),()=>t.value(`optics`)||`lenticular`,e=>t.set({optics:e}),n,()=>t.value(`display`)===``),w({label:`Viewing cone`,applies:()=>e.across.views>1,range:()=>[2,120],steps:236,value:()=>t.number(`view-angle`,xe(e)),text:e=>`${S(e,1)}\u00b0`,set:e=>t.set({"view-angle":j(e)}),reset:()=>t.set({"view-angle":null})},n))}function Te(e,t){let n=()=>{let t=[[``,`As the scene has it`],[`studio`,`Studio`],[`none`,`None`],[`#ffffff`,`White`],[`#808080`,`Grey`],[`#7fa6d9`,`Sky blue`]],n=e.value(`environment`);return t.some(([e])=>e===n)?t:[...t,[n,n.split(`/`).pop()??n]]},r=()=>e.value(`integrator`)===`path`;return D(`Light`,T(`Shading`,()=>(e.about.choices.integrator??[]).map(A),()=>e.value(`integrator`),t=>e.set({integrator:t}),t),w({label:`Samples a pixel`,range:()=>[0,10],steps:10,value:()=>Math.log2(Math.max(1,Ee(e))),text:()=>String(Ee(e)),set:t=>e.set({spp:String(Math.round(2**t))}),reset:()=>e.set({spp:null})},t),T(`Surroundings`,n,()=>e.value(`environment`),t=>e.set({environment:t}),t),w({label:`Their strength`,applies:r,range:()=>[-4,4],steps:80,value:()=>Math.log2(e.number(`environment-strength`,1)),text:()=>`${j(e.number(`environment-strength`,1))}\u00d7`,set:t=>e.set({"environment-strength":j(2**t)}),reset:()=>e.set({"environment-strength":null})},t),w({label:`Turned by`,applies:r,range:()=>[-180,180],steps:360,value:()=>e.number(`environment-rotation`,0),text:e=>`${S(e,0)}\u00b0`,set:t=>e.set({"environment-rotation":j(t)}),reset:()=>e.set({"environment-rotation":null})},t),w({label:`Exposure of the render`,range:()=>[-6,6],steps:120,value:()=>e.number(`exposure`,0),text:e=>`${e>0?`+`:``}${S(e,1)}\u2009EV`,set:t=>e.set({exposure:j(t)}),reset:()=>e.set({exposure:null})},t),T(`Tone`,()=>(e.about.choices.tone??[]).map(A),()=>e.value(`tone`),t=>e.set({tone:t}),t))}function Ee(e){let t=e.number(`spp`,0);return t>0?t:e.value(`integrator`)===`path`?16:1}function De(e){if(!e)return``;let t=`${e.done} of ${e.frames} frame${e.frames===1?``:`s`}`;return e.state===`running`?e.frames===0?`Being set up`:`${t}${e.seconds_left===null?``:`, about ${he(e.seconds_left)} left`}`:e.state===`finished`?`Finished: ${e.folder}`:e.state===`stopped`?`Stopped after ${t}: ${e.folder}`:e.error}function Oe(e,t){let n=x(`output`,{className:`value job`}),r=x(`progress`,{max:1});r.setAttribute(`aria-label`,`Render`);let i=O(`Cancel`,()=>e.cancel()),a=[O(`Render all frames`,()=>e.render(`all`)),O(`Render this frame`,()=>e.render(`this`))],o=()=>e.state?.render?.state===`running`;return t.push({update:()=>{let{state:t}=e,s=t?.saved?`Saved: ${t.saved}`:``;n.value=[s,De(t?.render??null)].filter(Boolean).join(`
`),r.hidden=i.hidden=!o(),a.forEach(e=>e.hidden=o()),r.value=t?.render?.share??0}}),D(`Job`,x(`div`,{className:`buttons`},O(`Save job`,()=>void e.save()),...a,i),r,x(`div`,{className:`row panel`},n))}var ke=(e,t,n,r)=>[Se(e,n,r),we(t,n,r),Te(n,r),Oe(n,r)],Ae=`sheet`,je=`file`,Me=e=>e instanceof Error?e.message:String(e),Ne=class{constructor(e,t,n,r,i,a,o){this.about=e,this.frames=n,this.state=r,this.take=i,this.changed=a,this.notify=o,this.file=null,this.made=null,this.isWanted=!1,this.isSeen=!1,this.awaitsClick=!1,this.madeOf=``,this.shownId=0,this.pending=0,this.hasPanel=!1,this.queue=Promise.resolve(),this.own={...t};let[s,c]=t.window_mm.size;this.settings={display:Ae,lpi:`60`,dpi:`600`,paper:`A5`,landscape:s>c,fit:``,shift:0}}get isBusy(){return this.pending>0}get shiftRange(){let{across:e,view_size:t}=this.own,n=.3*t[0]/Math.max(e.views-1,1);return[-n,n]}set(e){Object.assign(this.settings,e),this.notify(`print`,``),this.isWanted&&this.enqueue(()=>this.show()),this.changed(!1)}setShift(e){this.isWanted=!0,this.set({shift:e})}setPlane(e){let{across:t,view_size:n,window_mm:r}=this.own,i=(d(t,1-.5/t.views)-d(t,.5/t.views))/Math.max(t.views-1,1),[a,o]=this.shiftRange;this.awaitsClick=!1,this.setShift(Math.min(Math.max(-p(this.own,e)*i*n[0]/r.size[0],a),o))}see(e){this.isWanted=e,this.awaitsClick=!1,this.notify(`print`,``),this.enqueue(()=>this.show())}awaitClick(e){this.see(!1),this.awaitsClick=e,this.changed(!1)}async chooseFile(e){if(e.size>1<<19)return this.notify(`print`,`${e.name} is larger than 512 kB, and no display.`);this.file={name:e.name,text:await e.text()},this.set({display:je})}follow(){this.isWanted&&!this.isBusy&&(this.state().show===`display`?this.see(!1):this.isCurrent()||this.enqueue(()=>this.show()))}isCurrent(){return this.isSeen&&this.shownId===this.made?.id&&this.madeOf===this.request()&&(this.hasPanel||!this.needsPanel(this.made))}needsPanel(e){return this.state().show===`panel`&&e.field.panel.is===`own`}save(e){this.notify(`print`,``),this.enqueue(async()=>{let t=await this.make(),n=await this.picture(`file`,t),r=document.createElement(`a`);r.href=URL.createObjectURL(n),r.download=`${e.replace(/\.[^.]*$/,``)}-print.png`,r.click(),URL.revokeObjectURL(r.href)})}enqueue(e){this.pending++,this.changed(!1),this.queue=this.queue.then(e).catch(e=>{this.leave(),this.notify(`print`,Me(e))}).finally(()=>{this.pending--,this.changed(!1),this.follow()})}request(){let{display:e,lpi:t,dpi:n,paper:r,landscape:i,fit:a,shift:o}=this.settings,s=e===`file`&&this.file?{file:this.file}:{display:e===`sheet`?`lpi=${t} dpi=${n} paper=${r}${i?` landscape`:``}`:e};return JSON.stringify({frame:this.state().frame,...s,...a===``?{}:{fit:a},view_shift_px:o})}async make(){let e=this.request();return this.made&&this.madeOf===e||(this.made=JSON.parse(await _(`print`,e)),this.madeOf=e),this.made}async picture(t,n){let r=await b(`print/${t}/${n.id}`);if(r.size>0)return r;throw this.made=null,new e(`Another page has made a print meanwhile. Try again.`)}async show(){if(!this.isWanted)return this.leave();if(this.isCurrent())return;let e=await this.make(),t=this.needsPanel(e),n=await this.picture(`views`,e),r=t?await this.picture(`panel`,e):null,{frames:i,...a}=e.field;await this.frames.showLive({...this.own,...a},{views:n,depth:null,panel:r}),this.frames.isLive=!0,this.isSeen=!0,this.hasPanel=r!==null,this.shownId=e.id,this.take(a),this.changed(!0)}leave(){if(this.isWanted=!1,!this.isSeen)return;this.isSeen=!1,this.frames.endLive();let{frames:e,...t}=this.own;this.take(t),this.changed(!0)}},Pe=[`A3`,`A4`,`A5`,`A6`,`letter`,`5x7in`,`100x150mm`];function Fe(e,t,n){let{settings:r}=e,i=()=>[[Ae,`Lens sheet on paper`],...e.file?[[je,e.file.name]]:[],...e.about.displays.map(e=>[e,e])],a=()=>r.display===Ae,o=O(`Zero plane at a click`,()=>e.awaitClick(!e.awaitsClick));o.title=`The next click on the picture sets it`;let s=O(`Save the print`,t),c=x(`output`,{className:`job value`});return n.push({update:()=>{o.setAttribute(`aria-pressed`,String(e.awaitsClick)),s.disabled=e.isBusy,c.value=e.isBusy?`The print is being made…`:e.isSeen&&e.made?[e.made.description,e.made.fitted].filter(Boolean).join(`
`):``}}),D(`Print`,T(`Display`,i,()=>r.display,t=>e.set({display:t}),n),pe({label:`Lenses per inch`,value:()=>r.lpi,set:t=>e.set({lpi:t}),applies:a,numeric:!0},n),pe({label:`Dots per inch`,value:()=>r.dpi,set:t=>e.set({dpi:t}),applies:a,numeric:!0},n),pe({label:`Paper`,value:()=>r.paper,set:t=>e.set({paper:t}),applies:a,choices:Pe},n),E(`Landscape`,()=>r.landscape,t=>e.set({landscape:t}),n,a),T(`Views of another shape`,()=>[[``,`Automatic`],[`crop`,`Crop`],[`pad`,`Black bars`],[`stretch`,`Stretch`]],()=>r.fit,t=>e.set({fit:t}),n),E(`See through the sheet`,()=>e.isWanted,t=>e.see(t),n),w({label:`Zero plane`,late:()=>!0,range:()=>e.shiftRange,steps:600,value:()=>r.shift,text:e=>`${e>0?`+`:``}${S(e,2)}\u2009px a view`,set:t=>e.setShift(t),reset:()=>e.setShift(0)},n),c,x(`div`,{className:`buttons`},s,o,O(`From a file…`,()=>Ie(e))))}function Ie(e){let t=document.createElement(`input`);Object.assign(t,{type:`file`,accept:`.toml,.json,application/json`}),t.addEventListener(`change`,()=>t.files?.[0]&&void e.chooseFile(t.files[0])),t.click()}var Le={running:`Stop`,starting:`Stop`,stopping:`Stopping…`,stopped:`Resume`};function Re(e,t){let n=x(`output`,{className:`value job`});n.setAttribute(`aria-live`,`off`);let r=x(`progress`,{});r.setAttribute(`aria-label`,`Render`);let i=O(``,()=>void e.toggle()),a=x(`div`,{className:`buttons`},i);return t.push({update:()=>{let{done:t,frames:o,state:s,folder:c}=e.state;n.value=`${e.describe()}\n${c}`,r.max=o,r.value=t,r.hidden=s===`finished`,i.textContent=Le[s]??``,i.setAttribute(`aria-disabled`,String(s===`stopping`)),a.hidden=!(s in Le)}}),D(`Render`,x(`div`,{className:`row panel`},n),r,a)}function F(e,t,n,r,i,a=()=>!0){let o=T(e,()=>n,()=>String(r.state[t]),e=>r.set({[t]:e}),i,a);return i[i.length-1].update(),o}function ze(e,t,n){let r=[],{fields:i}=t,a=i[0],o=n.live?.about.plays??!1,s=()=>a.across.views*a.up.views>1;e.append(...[o?qe(n.player,!0,r):null,...n.live?ke(t,a,n.live,r):[],n.run?Re(n.run,r):null,i.length>1?Je(t,r):null,Ge(()=>s()&&t.state.show!==`display`,He(t,a,n,r),r),Ge(()=>s()&&t.state.show!==`display`,Ue(t,n,r),r),We(t,a,n,s,r),n.print?Ge(()=>t.state.show!==`display`,Fe(n.print,n.savePrint,r),r):null,o?null:qe(n.player,n.live!==null,r),x(`div`,{className:`buttons`},O(`Save picture`,n.save),O(`Copy link`,n.copy),O(`Reset`,()=>t.reset()))].filter(e=>e!==null));let c=()=>r.forEach(e=>e.update());return t.listen(c),c(),c}function Be(e,t){let n=O(`Tilt moves the eye`,()=>void e.toggle()),r=x(`div`,{className:`row`},n);return t.push({update:()=>{r.hidden=!e.isThere,n.setAttribute(`aria-pressed`,String(e.isOn))}}),r}function Ve(e,t){let n=O(`Enter VR`,()=>void e.toggle()),r=x(`div`,{className:`row`},n);return t.push({update:()=>{r.hidden=!e.isThere,n.textContent=e.isOn?`Leave VR`:`Enter VR`}}),r}function He(e,t,n,r){let{state:i}=e,a=()=>e.fields.length<2||i.compare===`first`||i.compare===`second`,o=e=>i.eye[e]/i.eye[2],s=(n,r)=>{let a=[...i.eye];a[n]=d(n===0?t.across:t.up,r)*a[2],e.set({eye:a})},c=(e,n)=>w({label:e,applies:()=>(n===0?t.across:t.up).views>1,range:()=>[0,1],value:()=>f(n===0?t.across:t.up,o(n)),text:()=>`${S(i.eye[n],1)}\u2009mm`,set:e=>s(n,e),reset:()=>s(n,.5)},r),l=()=>t.eye_mm[2];return D(`Eye`,c(`Left to right`,0),c(`Down to up`,1),w({label:`Distance`,unit:`mm`,range:()=>[-2,2],value:()=>Math.log2(i.eye[2]/l()),text:()=>`${S(i.eye[2],0)}\u2009mm`,set:t=>{let n=l()*2**t;e.set({eye:[o(0)*n,o(1)*n,n]})}},r),Be(n.tilt,r),Ve(n.headset,r),F(`Two eyes`,`stereo`,[[`off`,`Off`],[`anaglyph`,`Anaglyph, red and cyan`],[`side-by-side`,`Side by side`],[`top-bottom`,`Top and bottom`]],e,r,a),w({label:`Eye separation`,unit:`mm`,applies:()=>a()&&i.stereo!==`off`,range:()=>[0,Math.max(80,i.separation)],value:()=>i.separation,set:t=>e.set({separation:t})},r))}function Ue(e,t,n){let{state:r}=e;return D(`Focus`,w({label:`Aperture`,range:()=>[0,1],value:()=>r.aperture,text:e=>e===0?`all in focus`:`${S(100*e,0)}\u2009% of the zone`,set:t=>e.set({aperture:t})},n),w({label:`Depth in focus`,unit:`mm`,applies:()=>r.aperture>0,range:t.focusRange,value:()=>r.focus,set:t=>e.set({focus:t})},n))}function We(e,t,n,r,i){let{state:a}=e;return D(`Picture`,Ke(e,r,i),F(`Between views`,`between`,[[`depth`,`Moved by their depth`],[`blend`,`Blended`]],e,i,()=>t.depth),E(`Show single lenses`,()=>a.lenses,t=>e.set({lenses:t}),i,()=>t.lens_samples.some(Boolean)),w({label:`Crosstalk`,late:()=>v(t),applies:()=>(te(t)||v(t)&&n.live===null&&!n.print?.isSeen)&&a.show===`eye`&&a.aperture===0,range:()=>[0,Math.max(2,a.crosstalk)],value:()=>a.crosstalk,text:e=>e===0?`none`:`${S(e,2)}\u2009px, ${S(100*re(e),1)}\u2009%`,set:t=>e.set({crosstalk:Math.round(100*t)/100}),reset:()=>e.set({crosstalk:0})},i),F(`Overlay`,`overlay`,[[`none`,`None`],[`provenance`,`Where pixels came from`],[`missed`,`Missed pixels`]],e,i,()=>t.provenance!==null&&a.show!==`display`),E(`Epipolar-plane image`,()=>a.line>=0,t=>e.set({line:t?.5:-1}),i,()=>t.across.views>1),w({label:`Line, from the top`,applies:()=>a.line>=0,range:()=>[0,1],value:()=>a.line,text:e=>`${S(100*e,0)}\u2009%`,set:t=>e.set({line:t})},i),w({label:`Exposure`,applies:()=>a.show!==`display`,range:()=>[-4,4],steps:80,value:()=>a.exposure,text:e=>`${e>0?`+`:``}${S(e,1)}\u2009EV`,set:t=>e.set({exposure:t}),reset:()=>e.set({exposure:0})},i),E(`Light background`,()=>a.theme===`light`,t=>e.set({theme:t?`light`:`dark`}),i))}function Ge(e,t,n){return n.push({update:()=>t.hidden=!e()}),t}function Ke(e,t,n){let r=F(`Show`,`show`,[[`eye`,`What the eye sees`],[`panel`,`What the panel shows`],[`display`,`Played on a calibrated panel`]],e,n,()=>t()||e.plays),i=r.querySelector(`option[value="display"]`);return n.push({update:()=>i.hidden=i.disabled=!e.plays}),r}function qe(e,t,n){let r=O(`Full screen`,()=>void e.toggleFullScreen()),i=O(`Set up in another window`,()=>e.openSetUp()),a=x(`output`,{className:`value`});n.push({update:()=>{a.value=e.describe(),r.hidden=!e.isPlaying||!e.canFillScreen,i.hidden=!e.isPlaying||!t}});let o=O(`Calibration…`,()=>e.choose());return o.title=`visual.json of the panel; it may be dropped on the page, too`,D(`Calibrated panel`,x(`div`,{className:`row panel`},a),x(`div`,{className:`buttons`},r,i,o))}function Je(e,t){let{state:n,fields:r}=e;return D(`Compare`,F(`Show`,`compare`,[[`wipe`,`Both, wiped`],[`side-by-side`,`Side by side`],[`difference`,`Difference`],[`first`,`First: ${r[0].title}`],[`second`,`Second: ${r[1].title}`]],e,t),w({label:`Wipe`,applies:()=>n.compare===`wipe`,range:()=>[0,1],value:()=>n.wipe,text:e=>`${S(100*e,0)}\u2009%`,set:t=>e.set({wipe:t})},t),w({label:`Scale of differences`,applies:()=>n.compare===`difference`,range:()=>[1,255],steps:254,value:()=>n.scale,text:e=>`0 to ${S(e,0)} codes`,set:t=>e.set({scale:t})},t))}var Ye=1<<20;function Xe(e){let t=e.createReader(),n=[];return new Promise((e,r)=>{let i=()=>t.readEntries(t=>{n.push(...t),t.length>0?i():e(n)},r);i()})}var Ze=e=>new Promise((t,n)=>e.file(t,n)),Qe=e=>e.startsWith(`.`)||/^(thumbs\.db|desktop\.ini)$/i.test(e)||/\.(txt|md|pdf|xmp)$/i.test(e),$e=e=>e.filter(e=>!Qe(e.name));function et(e){let t=[...e.items].map(e=>e.webkitGetAsEntry());return t.length>1||t.some(e=>e?.isDirectory)||[...e.files].some(e=>e.type.startsWith(`image/`))}async function tt(t){let n=[...t.items].map(e=>e.webkitGetAsEntry()),r=[...t.files],i=n.find(e=>e?.isDirectory);if(!i)return{title:`Pictures`,files:r};if(n.length>1)throw new e(`Drop one folder, or pictures alone.`);let a=await Promise.all((await Xe(i)).filter(e=>e.isFile).map(e=>Ze(e)));return{title:i.name,files:$e(a)}}async function nt({title:e,files:t},n){await _(`drop/begin`,JSON.stringify({title:e,names:t.map(e=>e.name)}));let r=t.reduce((e,t)=>e+t.size,0),i=0;for(let[e,a]of t.entries())for(let t=0;t<a.size;t+=Ye){let o=a.slice(t,t+Ye);await se(`drop/${e}/${t}`,o),i+=o.size,n(i/r)}await _(`drop/show`,`{}`),history.replaceState(null,``,location.pathname),location.reload()}var rt=class{constructor(e){this.said=x(`p`,{role:`status`}),this.isBusy=!1;let t=e=>{let t=x(`input`,{type:`file`,multiple:!0,webkitdirectory:e});e||(t.accept=`image/*,.exr,.hdr,.ppm,.pgm,.pfm,.tga,.tif,.tiff,.heic`),t.addEventListener(`change`,()=>{let n=[...t.files??[]],r=e?n[0]?.webkitRelativePath.split(`/`)[0]??`Pictures`:`Pictures`,i=e?$e(n.filter(e=>e.webkitRelativePath.split(`/`).length===2)):n;this.take(Promise.resolve({title:r,files:i}))}),t.click()};e.replaceChildren(x(`h2`,{},`Drop pictures here`),x(`p`,{},`Two or more pictures of one scene, or a folder of them: the first in the order of their names is the view from the left.`),x(`div`,{className:`buttons`},O(`Choose pictures…`,()=>t(!1)),O(`Choose a folder…`,()=>t(!0))),this.said),e.hidden=!1,it(e=>void this.take(e))}async take(t){if(!this.isBusy){this.isBusy=!0;try{await nt(await t,e=>this.said.textContent=`${Math.round(100*e)}\u2009%`)}catch(t){this.said.textContent=t instanceof e?t.message:String(t)}this.isBusy=!1}}};function it(e){window.addEventListener(`dragover`,e=>e.preventDefault()),window.addEventListener(`drop`,t=>{t.preventDefault(),t.dataTransfer&&e(tt(t.dataTransfer))})}function I(t,n){if(!t)throw new e(`The description of the panel is damaged: ${n}.`)}var L=e=>typeof e==`number`&&Number.isFinite(e),R=(e,t,n)=>Array.isArray(e)&&e.length===t&&e.every(n),at=e=>R(e,2,L),ot=e=>R(e,3,at),st=e=>R(e,2,ot);function ct(e){let t=e;I(typeof t==`object`&&!!t,`it is no object`),I(R(t.pixels,2,e=>Number.isInteger(e)&&e>=1&&e<=65536),`it has no size`);let n=t.panel;return I(L(n?.periods)&&L(n.tilt)&&L(n.center),`it does not say where its lenses are`),I(R(n.sub_pixels,4,st),`it does not say where its sub-pixels are`),I([`nearest`,`linear`,`gaussian`].includes(t.filter)&&L(t.sigma_views),`it does not say how views are mixed`),t}var lt=(e,t)=>JSON.stringify(e)===JSON.stringify(t),ut=async e=>ct(JSON.parse(await _(`calibration`,e)));function dt(t){let n=t.getContext(`webgl2`,{alpha:!1,antialias:!1,depth:!1,preserveDrawingBuffer:!0});if(!n)throw new e(`This browser has no WebGL 2, which the page draws with. Any current browser with graphics enabled has it.`);return n.getExtension(`EXT_color_buffer_float`),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.NONE),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_ALIGNMENT,1),n}function ft(e,t,n){let r=e.createShader(t);if(e.shaderSource(r,n),e.compileShader(r),!e.getShaderParameter(r,e.COMPILE_STATUS)&&!e.isContextLost())throw Error(`shader: ${e.getShaderInfoLog(r)}`);return r}var pt=`#version 300 es
  void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    gl_Position = vec4(corner, 0.0, 1.0);
  }`,z=class{constructor(e,t,n=pt){if(this.gl=e,this.places=new Map,this.program=e.createProgram(),e.attachShader(this.program,ft(e,e.VERTEX_SHADER,n)),e.attachShader(this.program,ft(e,e.FRAGMENT_SHADER,t)),e.linkProgram(this.program),!e.getProgramParameter(this.program,e.LINK_STATUS)&&!e.isContextLost())throw Error(`program: ${e.getProgramInfoLog(this.program)}`)}draw(e,t=3){let n=this.gl;n.useProgram(this.program);for(let[t,n]of Object.entries(e))this.setUniform(t,n);n.drawArrays(n.TRIANGLE_STRIP,0,t)}setUniform(e,t){let n=this.gl;this.places.has(e)||this.places.set(e,n.getUniformLocation(this.program,e));let r=this.places.get(e);r!==null&&(typeof t==`boolean`?n.uniform1i(r,+!!t):typeof t==`number`?n.uniform1f(r,t):`unit`in t?n.uniform1i(r,t.unit):`integers`in t?t.integers.length===1?n.uniform1i(r,t.integers[0]):n.uniform2i(r,t.integers[0],t.integers[1]):t.length===2?n.uniform2fv(r,t):t.length===3?n.uniform3fv(r,t):t.length===16?n.uniformMatrix4fv(r,!1,t):n.uniform4fv(r,t))}};function B(e,t,n){return e.activeTexture(e.TEXTURE0+t),e.bindTexture(e.TEXTURE_2D,n),{unit:t}}function V(e,t,n=e.TEXTURE_2D){for(let r of[e.TEXTURE_MIN_FILTER,e.TEXTURE_MAG_FILTER])e.texParameteri(n,r,t);for(let t of[e.TEXTURE_WRAP_S,e.TEXTURE_WRAP_T])e.texParameteri(n,t,e.CLAMP_TO_EDGE)}function mt(e,t,n){let r=e.createTexture();return B(e,0,r),n===`srgb`?e.texImage2D(e.TEXTURE_2D,0,e.SRGB8_ALPHA8,e.RGBA,e.UNSIGNED_BYTE,t):e.texImage2D(e.TEXTURE_2D,0,e.RGBA8,e.RGBA,e.UNSIGNED_BYTE,t),V(e,n===`srgb`?e.LINEAR:e.NEAREST),r}function ht(e,t,n,r){let i=e.createTexture();return B(e,0,i),e.texImage2D(e.TEXTURE_2D,0,e.RG32UI,t,n,0,e.RG_INTEGER,e.UNSIGNED_INT,r),V(e,e.NEAREST),i}var gt=class{constructor(e,t,n){this.gl=e,this.texture=e.createTexture(),B(e,0,this.texture),e.texImage2D(e.TEXTURE_2D,0,e.RGBA8,t,n,0,e.RGBA,e.UNSIGNED_BYTE,null),V(e,e.NEAREST),this.framebuffer=e.createFramebuffer(),e.bindFramebuffer(e.FRAMEBUFFER,this.framebuffer),e.framebufferTexture2D(e.FRAMEBUFFER,e.COLOR_ATTACHMENT0,e.TEXTURE_2D,this.texture,0),e.viewport(0,0,t,n)}end(){return this.gl.bindFramebuffer(this.gl.FRAMEBUFFER,null),this.gl.deleteFramebuffer(this.framebuffer),this.texture}},H=class{constructor(e){this.gl=e,this.size=[0,0],this.texture=e.createTexture(),this.framebuffer=e.createFramebuffer()}get width(){return this.size[0]}get height(){return this.size[1]}begin(e,t){let n=this.gl;(this.size[0]!==e||this.size[1]!==t)&&(B(n,0,this.texture),n.getExtension(`EXT_color_buffer_float`)?n.texImage2D(n.TEXTURE_2D,0,n.RGBA16F,e,t,0,n.RGBA,n.HALF_FLOAT,null):n.texImage2D(n.TEXTURE_2D,0,n.SRGB8_ALPHA8,e,t,0,n.RGBA,n.UNSIGNED_BYTE,null),V(n,n.LINEAR),n.bindFramebuffer(n.FRAMEBUFFER,this.framebuffer),n.framebufferTexture2D(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,this.texture,0),this.size=[e,t]),n.bindFramebuffer(n.FRAMEBUFFER,this.framebuffer),n.viewport(0,0,e,t)}read(e,t,n,r){let i=this.gl;i.bindFramebuffer(i.FRAMEBUFFER,this.framebuffer);let a=new Float32Array(n*r*4);if(i.getExtension(`EXT_color_buffer_float`))return i.readPixels(e,t,n,r,i.RGBA,i.FLOAT,a),a;let o=new Uint8Array(a.length);return i.readPixels(e,t,n,r,i.RGBA,i.UNSIGNED_BYTE,o),a.map((e,t)=>_t(o[t]))}},_t=e=>{let t=e/255;return t<=.04045?t/12.92:((t+.055)/1.055)**2.4},vt=e=>{let t=Math.min(Math.max(e,0),1);return Math.floor(255*(t<=.0031308?12.92*t:1.055*t**(1/2.4)-.055)+.5)},yt=[`#d55e00`,`#0072b2`,`#009e73`,`#f0e442`,`#cc79a7`,`#ffffff`,`#56b4e9`,`#4a3aa8`],bt={provenance:.65,missed:.95,none:0},xt=e=>[1,3,5].map(t=>_t(parseInt(e.slice(t,t+2),16))),St=(e,t)=>e!==void 0&&(t===`provenance`||e.missed),Ct=(e,t)=>yt.flatMap((n,r)=>[...xt(n),St(e.provenance?.[r],t)?bt[t]:0]);function wt(e,t){let n=Math.max(1,Math.min(e.height,Math.floor((1<<20)/e.width))),r=new OffscreenCanvas(e.width,n).getContext(`2d`,{willReadFrequently:!0}),i=Array(t).fill(0);for(let t=0;t<e.height;t+=n){let a=Math.min(n,e.height-t);r.drawImage(e,0,t,e.width,a,0,0,e.width,a);let o=r.getImageData(0,0,e.width,a).data;for(let e=0;e<o.length;e+=4)i[o[e]]++}return i.map(t=>t/(e.width*e.height))}function Tt(e){return e>0&&e<.001?`< 0.1 %`:`${(100*(e<1?Math.min(e,.999):e)).toFixed(1)}\u2009%`}function Et(e,t,n){let r=document.createElement(`li`),i=document.createElement(`i`);i.style.background=e;let a=document.createElement(`span`);return a.textContent=Tt(n),r.append(i,`${t} `,a),r}function Dt(e,t,n,r){let i=t.provenance??[];if(e.hidden=n===`none`||r===null,e.hidden||r===null)return;let a=i.flatMap((e,t)=>r[t]>0&&St(e,n)?[Et(yt[t],e.name,r[t])]:[]);a.length===0&&a.push(Et(`transparent`,`missed`,0)),e.replaceChildren(...a)}var Ot={srgb:e=>[e.SRGB8_ALPHA8,e.RGBA],codes:e=>[e.RGBA8,e.RGBA],indices:e=>[e.R8,e.RED]};function U(e,{width:t,height:n},r){let i=e.getParameter(e.MAX_TEXTURE_SIZE);if(Math.max(t,n)<=i)return null;let a=(e,t)=>Math.min(t,Math.max(1,Math.floor(i/(e/t))));return[a(t,r[0]),a(n,r[1])]}function W(e,t,n,r){let[i,a]=Ot[r](e),o=U(e,t,n),s=e.createTexture();return G(e,0,s,o),o?kt(e,t,n,o,[i,a]):e.texImage2D(e.TEXTURE_2D,0,i,a,e.UNSIGNED_BYTE,t),V(e,r===`srgb`?e.LINEAR:e.NEAREST,o?e.TEXTURE_2D_ARRAY:e.TEXTURE_2D),s}function kt(e,t,n,r,[i,a]){let o=[t.width/n[0],t.height/n[1]],[s,c]=[o[0]*r[0],o[1]*r[1]],[l,u]=[Math.ceil(n[0]/r[0]),Math.ceil(n[1]/r[1])];e.texStorage3D(e.TEXTURE_2D_ARRAY,1,i,s,c,l*u);for(let n=0;n<l*u;n++){let[r,i]=[n%l*s,Math.floor(n/l)*c];e.pixelStorei(e.UNPACK_SKIP_PIXELS,r),e.pixelStorei(e.UNPACK_SKIP_ROWS,i),e.texSubImage3D(e.TEXTURE_2D_ARRAY,0,0,0,n,Math.min(s,t.width-r),Math.min(c,t.height-i),1,a,e.UNSIGNED_BYTE,t)}e.pixelStorei(e.UNPACK_SKIP_PIXELS,0),e.pixelStorei(e.UNPACK_SKIP_ROWS,0)}function G(e,t,n,r){return r?(e.activeTexture(e.TEXTURE0+t),e.bindTexture(e.TEXTURE_2D_ARRAY,n),{unit:t}):B(e,t,n)}var At=`
#if LAYERED
#define QUILT sampler2DArray
precision highp sampler2DArray;
uniform ivec2 u_layer_tiles;
#else
#define QUILT sampler2D
#endif
// Of a tile, counted from the top left: its place in pixels, and its layer. In floats: software graphics divide integers one by one.
vec3 place_of_tile(vec2 tile, vec2 view_size, vec2 tiles) {
#if LAYERED
  vec2 size = vec2(u_layer_tiles), layer = floor((tile + 0.5) / size);
  return vec3((tile - layer * size) * view_size, layer.y * ceil(tiles.x / size.x) + layer.x);
#else
  return vec3(tile * view_size, 0.0);
#endif
}
vec4 texel_of(QUILT quilt, vec3 tile, vec2 pixel) {
#if LAYERED
  return texelFetch(quilt, ivec3(tile.xy + pixel, tile.z), 0);
#else
  return texelFetch(quilt, ivec2(tile.xy + pixel), 0);
#endif
}
`;function jt(e,t){let n=1/0,r=-1/0;for(let t=0;t<e.length;t+=4){let i=e[t]*256+e[t+1];i!==0&&(n=Math.min(n,i),r=Math.max(r,i))}if(n>r)return[-t,t];let i=e=>{let n=(e-1)/32767-1;return t*n/Math.max(1-Math.abs(n),1e-6)};return[i(n),i(r)]}async function Mt(e,t){let n=await createImageBitmap(e,{resizeWidth:512,resizeHeight:512,resizeQuality:`pixelated`,premultiplyAlpha:`none`,colorSpaceConversion:`none`}),r=new OffscreenCanvas(512,512).getContext(`2d`,{willReadFrequently:!0});r.drawImage(n,0,0),n.close();let[i,a]=jt(r.getImageData(0,0,512,512).data,t),o=.02*(a-i)+.001;return[i-o,a+o]}var Nt=e=>e.startsWith(`eye/`)?e.slice(3):``,Pt=[1,1],Ft=3e3,It=class{constructor(e,t,n,r,i){this.gl=e,this.fields=t,this.budget=n,this.changed=r,this.notice=i,this.loaded=new Map,this.loading=new Map,this.failures=new Map,this.bytes=0,this.asked=0,this.pinned=[],this.interlacer=null,this.isLive=!1,this.live=null,this.livePlayed=null,this.livePictures=null,this.isPlayed=!1,this.isRemaking=!1}key(e,t,n){return`${e}/${t}/${this.useFor(e,n)}`}useFor(e,t){return t.startsWith(`eye/`)&&!v(this.fields[e])?`eye`:t}get(t,n,r){if(this.isLive)return this.getLive(r);let{label:i,pending:a}=this.fields[t].frames[n];if(a)throw new e(`Frame ${i} is not rendered yet.`);let o=this.key(t,n,r),s=this.failureOf(o);if(s)throw s;let c=this.loaded.get(o);return c?(this.loaded.delete(o),this.loaded.set(o,c),c):(this.load(t,n,r),null)}failureOf(e){let t=this.failures.get(e);return t&&performance.now()-t.at<Ft?t.error:null}getLive(t){if(this.isPlayed=t===`display`,!this.isPlayed)return this.live;let n=this.livePictures?.facts;if(n&&n.up.views>1)throw new e(`The scene is set up for ${n.up.views} rows of views, and a panel shows one.`);return this.livePlayed||this.remakeLive(),this.livePlayed}async remakeLive(){!this.isRemaking&&this.livePictures&&(this.isRemaking=!0,await this.showLive(this.livePictures.facts,this.livePictures.pictures),this.isRemaking=!1,this.changed())}playedLive(e,t,n){return!this.isPlayed||!this.interlacer||e.up.views>1?null:this.played(e,n&&this.isOwnPicture(e)?null:t,n)}async showLive(e,t){let n=this.livePictures={facts:e,pictures:t},r={premultiplyAlpha:`none`,colorSpaceConversion:`none`},i=async(e,t)=>e?this.fitted(await createImageBitmap(e,r),r,t):null,[a,o,s]=await Promise.all([i(t.views,e.tiles),i(t.depth,e.tiles),i(t.panel,Pt)]);if(!a)return;let c=o?await Mt(o,e.disparity_scale_mm):this.guessedRange(e);if(n!==this.livePictures)return[a,o,s].forEach(e=>e?.close());let l=[this.live,this.livePlayed];this.livePlayed=this.playedLive(e,a,s),this.live={layer:U(this.gl,a,e.tiles),views:W(this.gl,a,e.tiles,`srgb`),depth:o&&W(this.gl,o,e.tiles,`codes`),panel:s&&mt(this.gl,s,`srgb`),viewSize:[a.width/e.tiles[0],a.height/e.tiles[1]],disparities:c,bytes:0,whole:Promise.resolve()};for(let e of[a,o,s])e?.close();l.forEach(e=>e&&this.deleteTextures(e))}endLive(){this.isLive=!1;for(let e of[this.live,this.livePlayed])e&&this.deleteTextures(e);this.live=this.livePlayed=this.livePictures=null}pin(e,t){this.pinned=e.map(e=>`${e}/${t}/`)}get isLoading(){return this.loading.size>0}get isAsking(){return this.asked>0}peek(e,t,n){return this.isLive?this.live:this.loaded.get(this.key(e,t,n))??null}playOn(e,t){this.budget=t;for(let[e,t]of[...this.loaded])e.endsWith(`/display`)&&this.giveUp(e,t);this.failures.clear(),this.interlacer?.dispose(),this.interlacer=e,this.livePlayed&&this.deleteTextures(this.livePlayed),this.livePlayed=null}roomFor(e,t){let n=[...this.loaded].find(([n])=>n.startsWith(`${e}/`)&&n.endsWith(`/${t}`));return n?Math.max(1,Math.floor(this.budget/n[1].bytes)):1}load(e,t,n){if(this.isLive)return Promise.resolve(this.live);let r=this.key(e,t,n);if(this.fields[e].frames[t].pending||this.failureOf(r))return Promise.resolve(null);let i=this.loaded.get(r);if(i)return Promise.resolve(i);let a=this.loading.get(r);return a||(a=n===`display`?this.makePlayed(e,t):this.make(e,t,this.useFor(e,n)),this.loading.set(r,a),a.then(e=>this.keep(r,e)).catch(e=>this.failures.set(r,{error:e,at:performance.now()})).finally(()=>{this.loading.delete(r),this.changed()})),a.catch(()=>null)}keep(e,t){this.loaded.set(e,t),this.bytes+=t.bytes;for(let[t,n]of this.loaded){if(this.bytes<=this.budget)break;t===e||this.pinned.some(e=>t.startsWith(e))||this.giveUp(t,n)}}giveUp(e,t){this.loaded.delete(e),this.bytes-=t.bytes,t.givenUp=!0,this.deleteTextures(t)}deleteTextures(e){for(let t of new Set([e.views,e.depth,e.panel,e.provenance?.texture??null]))t&&this.gl.deleteTexture(t)}isOwnPicture(e){let t=this.interlacer?.display;return!!t&&lt(e.panel.panel,t.panel)&&e.panel.size.join()===t.pixels.join()}async makePlayed(e,t){let n=this.fields[e],r=n.frames[t].label,i=this.interlacer,a=this.isOwnPicture(n),o=a?await this.bitmap(`${e}/panel/${t}`,r,n.panel.size):await this.quilt(`${e}/views/${t}`,r,n);if(i!==this.interlacer)return o.close(),this.makePlayed(e,t);let s=this.played(n,a?null:o,a?o:null);return o.close(),s}played(e,t,n){let r=this.interlacer,i=t??n,a=t?e.tiles:Pt,o=U(this.gl,i,a),s=W(this.gl,i,a,`codes`),c=[i.width/e.tiles[0],i.height/e.tiles[1]],l=t?r.fromViews(e,s,c,o):r.fromOwn(s);this.gl.deleteTexture(s);let[u,d]=r.display.pixels;return{layer:null,views:l,depth:null,panel:l,viewSize:c,disparities:[0,0],bytes:4*u*d,whole:Promise.resolve()}}async make(e,t,n){let r=this.fields[e],i=r.frames[t].label,a=n===`panel`&&r.panel.is===`own`,[o,s]=await Promise.all([this.quilt(`${e}/views/${t}${Nt(n)}`,i,r),a?this.bitmap(`${e}/panel/${t}`,i,r.panel.size):null]),c={layer:U(this.gl,o,r.tiles),views:W(this.gl,o,r.tiles,`srgb`),depth:null,panel:s?mt(this.gl,s,`srgb`):null,viewSize:[o.width/r.tiles[0],o.height/r.tiles[1]],disparities:this.guessedRange(r),bytes:(r.provenance?o.width*o.height:0)+4*(o.width*o.height*(r.depth?2:1)+(s?s.width*s.height:0)),whole:Promise.resolve()};return o.close(),s?.close(),r.depth&&(c.whole=this.addDepth(c,e,t)),c}async addDepth(t,n,r){let i=this.fields[n];try{let e=await this.quilt(`${n}/depth/${r}`,i.frames[r].label,i);t.disparities=await Mt(e,i.disparity_scale_mm),t.depth=W(this.gl,e,i.tiles,`codes`),e.close(),t.givenUp&&this.gl.deleteTexture(t.depth),this.changed()}catch(t){this.notice(t instanceof e?t.message:`Frame ${i.frames[r].label}: its depth is damaged.`)}}wantProvenance(e,t,n){e.provenance===void 0&&(e.provenance=null,this.addProvenance(e,t,n))}async addProvenance(t,n,r){let i=this.fields[n];this.asked++;try{let e=await this.quilt(`${n}/provenance/${r}`,i.frames[r].label,i);t.givenUp||(t.provenance={texture:W(this.gl,e,i.tiles,`indices`),shares:wt(e,i.provenance?.length??0)}),e.close()}catch(t){this.notice(t instanceof e?t.message:`Frame ${i.frames[r].label}: where its pixels came from is damaged.`)}this.asked--,this.changed()}guessedRange(e){let t=e.depth_budget_mm??.2*e.window_mm.size[1];return[-2*t,2*t].map(t=>t/Math.max(1-t*e.vergence_per_mm,.2))}quilt(e,t,n){return this.bitmap(e,t,[n.tiles[0]*n.view_size[0],n.tiles[1]*n.view_size[1]],n.tiles)}async bitmap(t,n,r,i=Pt){let a=await b(t),o={premultiplyAlpha:`none`,colorSpaceConversion:`none`},s;try{s=await createImageBitmap(a,o)}catch{throw new e(`Frame ${n}: its picture is damaged and cannot be decoded.`)}if(s.width!==r[0]||s.height!==r[1])throw new e(`Frame ${n}: its picture has ${s.width}x${s.height} pixels, and the description says ${r[0]}x${r[1]}.`);return this.fitted(s,o,i)}async fitted(e,t,n){let r=this.gl.getParameter(this.gl.MAX_TEXTURE_SIZE),i=[e.width/n[0],e.height/n[1]],a=Math.ceil(Math.max(...i)/r);if(a<=1)return e;this.notice(`Shown at 1/${a} of its size: this device's GPU takes ${r} pixels a side.`);let[o,s]=i.map((e,t)=>n[t]*Math.floor(e/a)),c=await createImageBitmap(e,{...t,resizeWidth:o,resizeHeight:s,resizeQuality:`pixelated`});return e.close(),c}},Lt=class{constructor(e,t,n,r,i){this.about=e,this.field=t,this.frames=n,this.changed=r,this.notify=i,this.state=null,this.wanted={},this.waiting=null,this.confirmed=0,this.sending=!1,this.shownId=0,this.shownVersion=0,this.states=0,n.isLive=!0,this.listen()}value(e){return this.wanted[e]??this.state?.settings[e]??``}pendingNumber(e){return e in this.wanted?Number(this.wanted[e]):void 0}number(e,t){let n=this.value(e),r=Number(n);return n===``||!Number.isFinite(r)?t:r}get shownFrame(){return this.shownId>0?this.state?.picture?.frame??-1:-1}get isAtRest(){let{state:e}=this,t=e?.picture;return!!e&&!!t&&!this.isOutdated&&t.id===this.shownId&&t.version===e.version&&t.pass===`final`}get isOutdated(){return this.shownId>0&&(this.sending||this.waiting!==null||this.shownVersion<Math.max(this.state?.version??0,this.confirmed))}get isNew(){return this.states<=1}get othersFrame(){let{state:e}=this;return!e||this.sending||this.waiting||e.version<this.confirmed?null:e.frame}set(e){for(let[t,n]of Object.entries(e))n!==null&&(this.wanted[t]=n);this.notify(`asked`,``),this.waiting={...this.waiting,settings:{...this.waiting?.settings,...e}},this.send(),this.changed(!1)}setFrame(e){this.state&&(e!==this.state.frame||this.waiting)&&(this.waiting={...this.waiting,frame:e},this.send())}setPlane(e){this.waiting={...this.waiting,plane_mm:e},this.send()}async send(){if(this.sending||!this.waiting)return;this.sending=!0;let e=this.waiting;this.waiting=null;try{this.confirmed=(await this.post(`settings`,e)).version,this.notify(`setting`,``)}catch(e){this.wanted={},this.notify(`setting`,e instanceof Error?e.message:String(e))}this.sending=!1,this.send(),this.changed(!1)}async post(e,t){return JSON.parse(await _(`live/${e}`,JSON.stringify(t)))}async ask(e,t){try{await this.post(e,t),this.notify(`asked`,``)}catch(e){this.notify(`asked`,e instanceof Error?e.message:String(e))}}async save(){await this.ask(`save`,{})}render(e){this.ask(`render`,{frames:e})}cancel(){this.ask(`cancel`,{})}async listen(){for(;;){let t=performance.now();try{let e=await ce(`live/state/${this.state?.serial??0}`),n=this.state,r=this.shownId,i=e.serial!==n?.serial||e.share!==n.share||JSON.stringify(e.render)!==JSON.stringify(n.render);this.take(e),i&&this.changed(!1),e.picture&&e.picture.id!==this.shownId&&await this.load(e.picture),r!==this.shownId&&this.changed(!0),this.notify(`server`,``),!i&&performance.now()-t<100&&await k(250)}catch(t){this.notify(`server`,t instanceof e?t.message:String(t)),await k(2e3)}}}take(e){this.state=e,this.states++,!this.sending&&!this.waiting&&e.version>=this.confirmed&&(this.wanted={}),this.notify(`error`,e.error)}async load(e){let{id:t,version:n,field:r}=e,[i,a,o]=await Promise.all([b(`live/views/${t}`),e.depth?b(`live/depth/${t}`):null,e.panel&&r.panel.is===`own`?b(`live/panel/${t}`):null]);[i,a,o].some(e=>e?.size===0)||(await this.frames.showLive({...this.field,...r},{views:i,depth:a,panel:o}),Object.assign(this.field,r),this.shownId=t,this.shownVersion=n)}},Rt=33,zt=45,Bt=20,Vt=4,K=8,Ht=20,Ut=class{constructor(){this.divisor=1,this.needed=1,this.tooFine=0,this.quiet=K,this.at=0,this.intervals=[]}rests(){return this.quiet=Math.min(this.quiet+1,K),this.quiet===K&&this.divisor>1}draws(e,t){let n=this.quiet===K;return t?(n?this.tooFine=0:this.quiet===0&&this.divisor===this.needed&&this.learn(e-this.at),this.quiet=0,this.at=e):this.quiet=Math.min(this.quiet+1,K),n?this.divisor=1:t&&(this.divisor=this.needed),this.divisor}learn(e){this.intervals.push(e);let t=this.intervals.slice(-2);t.length===2&&Math.min(...t)>zt?this.coarser(Math.min(...t)):this.intervals.length>=Ht&&this.finer()}coarser(e){this.tooFine=Math.max(this.tooFine,this.needed),this.needed=Math.min(Math.ceil(this.needed*Math.sqrt(e/Rt)),Vt),this.intervals=[]}finer(){Math.max(...this.intervals)<Bt&&this.needed-1>this.tooFine&&this.needed--,this.intervals=[]}},Wt=[`nearest`,`linear`,`gaussian`,`as they are`],Gt=(e,t)=>`#version 300 es
#define FILTER ${Wt.indexOf(e)}
#define LAYERED ${Number(t)}
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
${At}
uniform QUILT u_views;            // codes: the quilt, or the panel's own picture
uniform usampler2D u_rows;        // red, green, blue of even pixels, of odd ones: upper and lower words; rows from the bottom
uniform usampler2D u_columns;
uniform ivec2 u_view_size, u_tiles, u_panel_size;
uniform int u_count;
uniform bool u_inverted;
uniform float u_sigma;
out vec4 color;

// The fraction times the number of views, above and below the point.
uvec2 view_place(uvec2 fraction) {
  uint count = uint(u_count);
  uint lower = ((fraction.y >> 16u) * count + (((fraction.y & 0xffffu) * count) >> 16u)) >> 16u;
  uint middle = (fraction.x & 0xffffu) * count + lower;
  uint upper = (fraction.x >> 16u) * count + (middle >> 16u);
  return uvec2(upper >> 16u, (upper << 16u) | (middle & 0xffffu));
}

// v = fract(z) or 1 - fract(z), where 1 is of the last view.
uvec2 view_of(ivec2 pixel, int channel) {
  uvec2 row = texelFetch(u_rows, ivec2(3 * (pixel.x & 1) + channel, pixel.y), 0).xy;
  uvec2 column = texelFetch(u_columns, ivec2(pixel.x, 0), 0).xy;
  uint low = row.y + column.y;
  uvec2 z = uvec2(row.x + column.x + (low < row.y ? 1u : 0u), low);
  if (!u_inverted) return view_place(z);
  if (z == uvec2(0u)) return uvec2(uint(u_count), 0u);
  return view_place(uvec2(~z.x + (z.y == 0u ? 1u : 0u), ~z.y + 1u));
}

vec3 origin_of(int view) {
  return place_of_tile(vec2(view % u_tiles.x, u_tiles.y - 1 - view / u_tiles.x), vec2(u_view_size), vec2(u_tiles));
}
float code(vec3 origin, ivec2 at, int channel) { return texel_of(u_views, origin, vec2(at))[channel]; }

float nearest(int view, ivec2 pixel, int channel) {
  ivec2 from_top = ivec2(pixel.x, u_panel_size.y - 1 - pixel.y);
  return code(origin_of(view), ((2 * from_top + 1) * u_view_size) / (2 * u_panel_size), channel);
}

float bilinear(int view, ivec2 pixel, int channel) {
  vec2 from_top = vec2(pixel.x, u_panel_size.y - 1 - pixel.y) + 0.5;
  vec2 place = clamp(from_top * vec2(u_view_size) / vec2(u_panel_size) - 0.5, vec2(0.0), vec2(u_view_size - 1));
  ivec2 at = ivec2(place), next = min(at + 1, u_view_size - 1);
  vec3 origin = origin_of(view);
  vec2 share = place - vec2(at);
  float top = mix(code(origin, at, channel), code(origin, ivec2(next.x, at.y), channel), share.x);
  float below = mix(code(origin, ivec2(at.x, next.y), channel), code(origin, next, channel), share.x);
  return mix(top, below, share.y);
}

float between(uvec2 place, ivec2 pixel, int channel) {
  // View n is what (n + 1/2) / N sees.
  int view = int(place.x) - (place.y < 0x80000000u ? 1 : 0);
  float share = float(place.y ^ 0x80000000u) / 4294967296.0;
  if (view < 0) view = 0, share = 0.0;
  if (view >= u_count - 1) view = u_count - 1, share = 0.0;
#if FILTER == 1
  float here = bilinear(view, pixel, channel);
  return share == 0.0 ? here : mix(here, bilinear(view + 1, pixel, channel), share);
#else
  float reach = 3.0 * u_sigma + 0.5, sum = 0.0, weights = 0.0;
  int last = min(u_count - 1 - view, int(floor(share + reach)));
  for (int i = max(-view, int(ceil(share - reach))); i <= last; ++i) {
    float away = (float(i) - share) / u_sigma, weight = exp(-0.5 * away * away);
    sum += weight * bilinear(view + i, pixel, channel), weights += weight;
  }
  return sum / weights;
#endif
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 codes;
#if FILTER == 3
  codes = texel_of(u_views, vec3(0.0), vec2(pixel.x, u_panel_size.y - 1 - pixel.y)).rgb;
#else
  for (int channel = 0; channel < 3; ++channel) {
    uvec2 place = view_of(pixel, channel);
#if FILTER == 0
    codes[channel] = nearest(min(int(place.x), u_count - 1), pixel, channel);
#else
    codes[channel] = between(place, pixel, channel);
#endif
  }
#endif
  color = vec4(codes, 1.0);
}
`;function Kt(e){let t=new Uint32Array(2*e.length);return e.forEach((e,n)=>{let r=(e-Math.floor(e))*2**32;t[2*n]=r,t[2*n+1]=(r-Math.floor(r))*2**32}),t}function qt({pixels:e,panel:t}){let n=[];for(let r=0;r<e[1];r++)for(let i of t.sub_pixels[r%4])for(let[a,o]of i){let i=(.5+a)/e[0],s=(r+.5+o)/e[1];n.push((i+s*t.tilt)*t.periods-t.center)}return n}var Jt=class{constructor(t,n){this.gl=t,this.display=n,this.programs=new Map;let{pixels:r,panel:i}=n,a=t.getParameter(t.MAX_TEXTURE_SIZE);if(Math.max(...r)>a)throw new e(`The panel has ${r[0]}\u00d7${r[1]} pixels, and this device's GPU takes ${a} a side.`);this.rows=ht(t,6,r[1],Kt(qt(n)));let o=i.periods/r[0];this.columns=ht(t,r[0],1,Kt([...Array(r[0]).keys()].map(e=>e*o)))}fromViews(e,t,n,r){return this.draw(this.display.filter,t,r,{u_layer_tiles:{integers:r??e.tiles},u_view_size:{integers:n.map(Math.floor)},u_tiles:{integers:e.tiles},u_count:{integers:[e.across.views]},u_inverted:this.display.panel.inverted,u_sigma:this.display.sigma_views})}fromOwn(e){return this.draw(`as they are`,e,null,{})}draw(e,t,n,r){let i=this.gl,{pixels:a}=this.display,o=`${e}${n?`, layered`:``}`,s=this.programs.get(o)??new z(i,Gt(e,n!==null));this.programs.set(o,s);let c=new gt(i,a[0],a[1]);return s.draw({...r,u_views:G(i,0,t,n),u_rows:B(i,1,this.rows),u_columns:B(i,2,this.columns),u_panel_size:{integers:a}}),c.end()}dispose(){for(let e of[this.rows,this.columns])this.gl.deleteTexture(e)}};function Yt(){let e=navigator.deviceMemory??4;return Math.min(Math.max(e*256,512),2048)*1024*1024}var Xt=1<<20,q=([e,t])=>`${e}\u00d7${t}`,Zt=class{constructor(e,t,n,r,i,a){this.gl=e,this.store=t,this.frames=n,this.stage=r,this.notify=i,this.display=null,this.named=``,this.isDropped=!1,document.addEventListener(`fullscreenchange`,()=>this.store.touch()),window.addEventListener(`dragover`,e=>e.preventDefault()),window.addEventListener(`drop`,e=>{if(e.preventDefault(),e.dataTransfer&&et(e.dataTransfer))return a(tt(e.dataTransfer));let t=e.dataTransfer?.files[0];t&&this.take(t)})}playOn(t){let{up:n,title:r}=this.store.fields[0];if(n.views>1&&!this.frames.isLive)throw new e(`${r} has ${n.views} rows of views, and a panel shows one: \`lippmann convert --keep\` takes one of several.`);this.takeDisplay(t),this.store.set({show:`display`}),this.store.touch()}takeDisplay(e){this.frames.playOn(new Jt(this.gl,e),Yt()),this.display=e,this.store.plays=!0}follow(e){let t=JSON.stringify(e);t===this.named||this.isDropped||(this.named=t,e?this.takeDisplay(ct(e)):this.stop(),this.store.touch())}stop(){this.display=null,this.store.set({show:this.store.state.show===`display`?`eye`:this.store.state.show}),this.store.plays=!1}async take(t){this.notify(`calibration`,``);try{if(t.size>Xt)throw new e(`It is larger than 1 MB, and no calibration.`);this.playOn(await ut(await t.text())),this.isDropped=!0}catch(n){this.notify(`calibration`,`${t.name} cannot be used: ${n instanceof e?n.message:String(n)}`)}}choose(){let e=document.createElement(`input`);Object.assign(e,{type:`file`,accept:`.json,application/json`}),e.addEventListener(`change`,()=>e.files?.[0]&&void this.take(e.files[0])),e.click()}get isPlaying(){return this.store.state.show===`display`&&this.display!==null}get canFillScreen(){return document.fullscreenEnabled}async toggleFullScreen(){try{document.fullscreenElement?await document.exitFullscreen():await this.stage.requestFullscreen({navigationUI:`hide`})}catch{this.notify(`screen`,`The browser does not let this page fill the screen.`)}}openSetUp(){window.open(`${location.href.split(`#`)[0]}#show=eye`,`_blank`,`popup,width=1200,height=800`)}describe(){return this.display?`${this.display.name}, ${q(this.display.pixels)}`:`none`}fit(e){let[t,n]=this.display.pixels,r=e.width!==t||e.height!==n;r&&Object.assign(e,{width:t,height:n});let i=window.devicePixelRatio||1,a=document.fullscreenElement===this.stage;return e.style.width=a?`${t/i}px`:``,e.style.height=a?`${n/i}px`:``,this.notify(`screen`,this.screenNotice(a,i)),r}screenNotice(e,t){let{pixels:n}=this.display,{gl:r}=this;if(r.drawingBufferWidth!==r.canvas.width||r.drawingBufferHeight!==r.canvas.height)return`This device draws ${q([r.drawingBufferWidth,r.drawingBufferHeight])} pixels at most, and the panel has ${q(n)}.`;if(!e)return this.canFillScreen?`Shown as a picture. On the panel's screen, “Full screen” or F plays it pixel for pixel.`:`Shown as a picture: this browser cannot fill the screen.`;let i=[Math.round(window.innerWidth*t),Math.round(window.innerHeight*t)];return i.every((e,r)=>Math.abs(e-n[r])<=t)?``:`This screen has ${q(i)} pixels, and the panel ${q(n)}: move the window to the panel's screen.`}},Qt=`
precision highp float;
precision highp int;
precision highp sampler2D;

${At}
uniform QUILT u_views;        // linear light
uniform QUILT u_depth;        // codes of disparity, as the quilt lies
uniform vec2 u_view_size;     // pixels
uniform ivec2 u_tiles, u_grid;
uniform vec2 u_window_centre, u_window_size;  // mm
uniform vec4 u_across, u_up;  // first, step, 1: by angle, 0 stays / 1 repeats / 2 next lens
uniform float u_vergence, u_disparity_scale;
uniform vec3 u_eye;           // mm
#if OVERLAY
uniform QUILT u_provenance;      // codes, as the quilt lies
uniform vec4 u_tints[8];         // by code: a colour and how strong it is
#endif

vec2 slope_at(vec2 s) { return u_eye.xy / u_eye.z - s * (1.0 / u_eye.z - u_vergence); }

// Only rows of views are equally far apart in angle.
float view_place(vec4 axis, float slope) {
#if BY_ANGLE
  if (axis.z > 0.5) slope = atan(slope);
#endif
  return axis.y == 0.0 ? 0.0 : (slope - axis.x) / axis.y;
}
vec2 view_places(vec2 slope) { return vec2(view_place(u_across, slope.x), view_place(u_up, slope.y)); }

float view_slope(vec4 axis, float view) {
  float place = axis.x + axis.y * view;
#if BY_ANGLE
  if (axis.z > 0.5) return tan(place);
#endif
  return place;
}
vec2 view_slopes(ivec2 view) { return vec2(view_slope(u_across, float(view.x)), view_slope(u_up, float(view.y))); }

// In pixels of a view, from its top left corner.
vec2 pixel_of(vec2 s) {
  vec2 share = (s - u_window_centre) / u_window_size;
  return vec2(share.x + 0.5, 0.5 - share.y) * u_view_size;
}
bool inside(vec2 pixel) {
  return all(greaterThanEqual(pixel, vec2(-0.001))) && all(lessThanEqual(pixel, u_view_size + 0.001));
}

vec3 tile_of(ivec2 view) {
  float index = float(view.y * u_grid.x + view.x), columns = float(u_tiles.x);
  float row = floor((index + 0.5) / columns);
  return place_of_tile(vec2(index - row * columns, float(u_tiles.y) - 1.0 - row), u_view_size, vec2(u_tiles));
}
#if OVERLAY
// The brightness of what is seen stays readable below its tint.
vec3 with_origin(vec3 seen, vec3 tile, vec2 pixel) {
  vec4 tint = u_tints[int(texel_of(u_provenance, tile, pixel).r * 255.0 + 0.5) & 7];
  return mix(seen, tint.rgb * (0.2 + 0.8 * dot(seen, vec3(0.2126, 0.7152, 0.0722))), tint.a);
}
#endif
vec3 in_view(ivec2 view, vec2 pixel) {
  vec3 tile = tile_of(view);
  vec2 place = tile.xy + clamp(pixel, vec2(0.5), u_view_size - 0.5);
#if LAYERED
  vec3 seen = texture(u_views, vec3(place / (u_view_size * vec2(u_layer_tiles)), tile.z)).rgb;
#else
  vec3 seen = texture(u_views, place / (u_view_size * vec2(u_tiles))).rgb;
#endif
#if OVERLAY
  seen = with_origin(seen, tile, clamp(floor(pixel), vec2(0.0), u_view_size - 1.0));
#endif
  return seen;
}
// -1e30: nothing is there.
float disparity_in_tile(vec3 tile, vec2 pixel) {
  vec2 at = clamp(floor(pixel), vec2(0.0), u_view_size - 1.0);
  vec2 bytes = floor(texel_of(u_depth, tile, at).rg * 255.0 + 0.5);
  float code = bytes.x * 256.0 + bytes.y;
  if (code < 0.5) return -1e30;
  float t = (code - 1.0) / 32767.0 - 1.0;
  return u_disparity_scale * t / max(1.0 - abs(t), 1e-6);
}
float disparity_in_view(ivec2 view, vec2 pixel) { return disparity_in_tile(tile_of(view), pixel); }
`,$t=[`eye`,`refocus`,`line`,`find`],en=e=>`#version 300 es
#define BY_ANGLE ${Number(e.byAngle)}
#define ROWS ${Number(e.rows)}
#define DEPTH ${Number(e.depth)}
#define TASK ${$t.indexOf(e.task)}
#define SCREEN ${Number(e.screen)}
#define SNAP ${Number(e.snap)}
#define CROSSTALK ${Number(e.crosstalk)}
#define BUDGET ${Number(e.budget)}
#define OVERLAY ${Number(e.overlay)}
#define LAYERED ${Number(e.layered)}
`,tn=`
vec3 srgb(vec3 linear) {
  vec3 v = clamp(linear, 0.0, 1.0);
  return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, v));
}
`,nn=e=>`${en(e)}${Qt}${tn}
uniform vec2 u_output_size, u_offset;  // the picture's size, and its place on what is drawn to, pixels
uniform float u_exposure;
uniform bvec2 u_snap;           // to the middles of lenses
uniform vec2 u_disparities;     // the least and the greatest
uniform float u_aperture, u_focus;  // share of the zone; disparity
uniform float u_line;           // 0 ... 1: an epipolar-plane image of the line so far down, eyes from the top
uniform vec2 u_point;           // where the focus finder looks, mm
uniform float u_sigma;          // how far crosstalk spreads, views
uniform float u_budget;         // mm on either side of the plane
out vec4 color;

// Along the line of sight, front to back, the first disparity at which the view has a surface; .y: whether it is seen there.
// Behind what the view sees nearer it goes on: the line may come out on the other side. Where it does not, what is hidden looks
// as what is seen just before it goes behind. What all steps have in common is computed
// before them: they are most of the time that an eye takes.
vec2 meet(ivec2 view, vec2 s, vec2 apart) {
  vec3 tile = tile_of(view);
  vec2 start = pixel_of(s), per_disparity = apart * vec2(1.0, -1.0) * u_view_size / u_window_size;
  float range = u_disparities.y - u_disparities.x, per = max(abs(per_disparity.x), abs(per_disparity.y));
  int steps = clamp(int(ceil(per * range)), 1, 40);
  float step_w = range / float(steps), w = u_disparities.y, before = w;
  bool hidden = false;
  for (int edges = 0, i = 0; edges < 3 && i <= steps; ++edges) {
    float at = w;
    for (; i <= steps; ++i) {
      at = max(disparity_in_tile(tile, start + per_disparity * w), u_disparities.x);
      bool behind = at - w >= -1e-4 * range;
      if (behind && !hidden) break;
      hidden = behind;
      w -= step_w;
    }
    if (i > steps) break;
    // It came to be behind: at a surface, or beside the edge of one.
    float near = i == 0 ? w : w + step_w, far = w;
    for (int j = 0; j < 3; ++j) {
      float middle = 0.5 * (near + far);
      float there = max(disparity_in_tile(tile, start + per_disparity * middle), u_disparities.x);
      if (there >= middle) far = middle, at = there;
      else near = middle;
    }
    if (per * (at - far) < 0.75) return vec2(at, 1.0);
    before = near;
    hidden = true;
    w -= step_w;
    ++i;
  }
  return hidden ? vec2(before, 0.0) : vec2(u_disparities.x, 1.0);
}

#if BUDGET
// Green up to half the budget, yellow at its end, red at twice as much: there a display shows half the detail. What is nowhere
// has no depth.
vec3 tinted(ivec2 view, vec2 pixel, float disparity) {
  vec3 seen = in_view(view, pixel);
  if (disparity_in_view(view, pixel) < -1e29) return seen;
  float share = abs(disparity / max(1.0 + disparity * u_vergence, 0.02)) / u_budget;
  vec3 tint = mix(vec3(0.02, 0.6, 0.08), vec3(0.9, 0.55, 0.02), clamp(2.0 * share - 1.0, 0.0, 1.0));
  tint = mix(tint, vec3(0.8, 0.02, 0.01), clamp(share - 1.0, 0.0, 1.0));
  return mix(seen, tint * (0.12 + 0.88 * dot(seen, vec3(0.2126, 0.7152, 0.0722))), 0.7);
}
#endif

#if DEPTH
// As in_view, but without neighbouring texels of what is nearer, as these move away from it: wholly where they move by three
// quarters of a pixel.
vec3 in_view_behind(ivec2 view, vec2 pixel, vec2 per_disparity) {
  vec3 tile = tile_of(view);
  vec2 last = u_view_size - 1.0, at = clamp(pixel, vec2(0.5), u_view_size - 0.5) - 0.5, first = floor(at), share = at - first;
  vec2 next = min(first + 1.0, last);
  vec4 disparities = vec4(disparity_in_tile(tile, first), disparity_in_tile(tile, vec2(next.x, first.y)), disparity_in_tile(tile, vec2(first.x, next.y)), disparity_in_tile(tile, next));
  vec2 row = share.y < 0.5 ? disparities.xy : disparities.zw;
  float own = share.x < 0.5 ? row.x : row.y;
  vec4 moved = max(abs(per_disparity.x), abs(per_disparity.y)) * (disparities - own);  // infinite beside what is nowhere
  if (all(lessThan(moved, vec4(0.25)))) return in_view(view, pixel);
  vec2 rest = 1.0 - share;
  vec4 weights = vec4(rest.x * rest.y, share.x * rest.y, rest.x * share.y, share.x * share.y) * (1.0 - smoothstep(0.25, 0.75, moved));
  vec3 sum = weights.x * texel_of(u_views, tile, first).rgb + weights.y * texel_of(u_views, tile, vec2(next.x, first.y)).rgb;
  sum += weights.z * texel_of(u_views, tile, vec2(first.x, next.y)).rgb + weights.w * texel_of(u_views, tile, next).rgb;
  vec3 seen = sum / (weights.x + weights.y + weights.z + weights.w);
#if OVERLAY
  seen = with_origin(seen, tile, clamp(floor(pixel), vec2(0.0), last));
#endif
  return seen;
}
#endif

vec3 in_view_at(ivec2 view, vec2 s, vec2 slope, out float weight) {
  weight = 1.0;
#if DEPTH
  vec2 apart = slope - view_slopes(view);
  vec2 met = meet(view, s, apart);
  s += apart * met.x;
  weight = met.y > 0.5 ? 1.0 : 0.01;
#if BUDGET
  return tinted(view, pixel_of(s), met.x);
#endif
  return in_view_behind(view, pixel_of(s), apart * u_view_size / u_window_size);
#else
  return in_view(view, pixel_of(s));
#endif
}

vec3 between_views(vec2 s, vec2 slope, vec2 place) {
  vec2 last = vec2(u_grid - 1);
  vec2 near = clamp(place, vec2(0.0), last);
  ivec2 first = ivec2(min(floor(near), max(last - 1.0, vec2(0.0))));
  vec2 share = near - vec2(first);
  ivec2 right = ivec2(min(1, u_grid.x - 1), 0);
  vec4 weight;
  vec3 a = in_view_at(first, s, slope, weight.x), b = in_view_at(first + right, s, slope, weight.y);
  weight.xy *= vec2(1.0 - share.x, share.x);
#if ROWS
  ivec2 above = ivec2(0, min(1, u_grid.y - 1));
  vec3 c = in_view_at(first + above, s, slope, weight.z), d = in_view_at(first + right + above, s, slope, weight.w);
  weight *= vec4(vec2(1.0 - share.y), vec2(share.y)) * vec4(1.0, 1.0, 1.0 - share.x, share.x);
  return (a * weight.x + b * weight.y + c * weight.z + d * weight.w) / max(weight.x + weight.y + weight.z + weight.w, 1e-9);
#else
  return (a * weight.x + b * weight.y) / max(weight.x + weight.y, 1e-9);
#endif
}

// Beyond the zone: which cone (lens) it is that is seen instead, and the place there.
float wrapped(float place, float count, float beyond, out float turns) {
  turns = beyond > 0.5 ? floor((place + 0.5) / count) : 0.0;
  return place - turns * count;
}

#if CROSSTALK
// Abramowitz and Stegun 7.1.26, to 1.5e-7.
float erf(float x) {
  float t = 1.0 / (1.0 + 0.3275911 * abs(x));
  float series = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  return sign(x) * (1.0 - series * exp(-x * x));
}
// What view i has of a Gaussian at a place: as src/optics/crosstalk.cpp, where pixel i covers i ... i + 1.
float share_of(float i, float place) {
  float scale = 0.70710678 / u_sigma;
  return 0.5 * (erf((i + 1.0 - place) * scale) - erf((i - place) * scale));
}
// A lens images the pixels around the one that is meant, beyond the edge of its cell those of its neighbour.
vec3 through_lens(vec2 s, vec2 place) {
  vec2 count = vec2(u_grid), pitch = u_window_size / u_view_size, reach = vec2(4.0 * u_sigma);
#if !ROWS
  place.y = 0.0, reach.y = 0.0;
#endif
  vec2 first = floor(place + 0.5 - reach), last = floor(place + 0.5 + reach);
  bvec2 next_lens = greaterThan(vec2(u_across.w, u_up.w), vec2(1.5));
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (float j = first.y; j <= last.y; ++j)
    for (float i = first.x; i <= last.x; ++i) {
      vec2 turns = floor(vec2(i, j) / count);
      vec2 pixel = pixel_of(s - pitch * turns);
      bool there = (turns.x == 0.0 || next_lens.x) && (turns.y == 0.0 || next_lens.y) && inside(pixel);
      if (!there) continue;
      float weight = u_grid.x > 1 ? share_of(i, place.x + 0.5) : 1.0;
#if ROWS
      weight *= share_of(j, place.y + 0.5);
#endif
      sum += weight * in_view(ivec2(vec2(i, j) - turns * count), pixel);
      weights += weight;
    }
  return weights > 0.0 ? sum / weights : vec3(0.0);
}
#endif

vec3 seen(vec2 s) {
  vec2 pixel = pixel_of(s);
  if (!inside(pixel)) return vec3(0.0);
#if SNAP
  vec2 middle = (floor(clamp(pixel, vec2(0.0), u_view_size - 0.5)) + 0.5) / u_view_size;
  vec2 lens = u_window_centre + vec2(middle.x - 0.5, 0.5 - middle.y) * u_window_size;
  s = vec2(u_snap.x ? lens.x : s.x, u_snap.y ? lens.y : s.y);
#endif
  vec2 slope = slope_at(s), place = view_places(slope), turns;
  place = vec2(wrapped(place.x, float(u_grid.x), u_across.w, turns.x), wrapped(place.y, float(u_grid.y), u_up.w, turns.y));
  // Right of its zone a lens shows what belongs to its left neighbour.
  vec2 pitch = u_window_size / u_view_size;
  s -= pitch * vec2(u_across.w > 1.5 ? turns.x : 0.0, u_up.w > 1.5 ? turns.y : 0.0);
  if (!inside(pixel_of(s))) return vec3(0.0);
#if CROSSTALK
  vec2 last = vec2(u_grid - 1);
  if (u_across.w < 0.5) place.x = clamp(place.x, 0.0, last.x);
  if (u_up.w < 0.5) place.y = clamp(place.y, 0.0, last.y);
  return through_lens(s, place);
#endif
  if (turns != vec2(0.0)) slope = vec2(view_slope(u_across, place.x), view_slope(u_up, place.y));
  return between_views(s, slope, place);
}

// A lens as wide as a share of the zone around the eye, focused at a disparity: the mean of shifted views.
vec3 refocused(vec2 s) {
  vec2 slope = slope_at(s), place = view_places(slope), half_width = 0.5 * u_aperture * vec2(u_grid);
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int j = 0; j < u_grid.y; ++j)
    for (int i = 0; i < u_grid.x; ++i) {
      vec2 reach = clamp(half_width - abs(vec2(i, j) - place) + 0.5, 0.0, 1.0);
      if (u_aperture >= 0.999) reach = vec2(1.0);
      if (u_grid.y == 1) reach.y = 1.0;
      if (reach.x * reach.y <= 0.0) continue;
      vec2 pixel = pixel_of(s + (slope - view_slopes(ivec2(i, j))) * u_focus);
      if (!inside(pixel)) continue;
      sum += reach.x * reach.y * in_view(ivec2(i, j), pixel);
      weights += reach.x * reach.y;
    }
  return weights > 0.0 ? sum / weights : vec3(0.0);
}

// How much the views differ around u_point if the surface there were at the disparity of this pixel (0 ... 1 across).
float disagreement(float share) {
  float w = mix(u_disparities.x, u_disparities.y, share);
  float sum = 0.0;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      vec2 s = u_point + vec2(x, y) * u_window_size / u_view_size;
      vec2 slope = slope_at(s);
      vec3 mean = vec3(0.0), squares = vec3(0.0);
      float count = 0.0;
      for (int j = 0; j < u_grid.y; ++j)
        for (int i = 0; i < u_grid.x; ++i) {
          vec2 pixel = pixel_of(s + (slope - view_slopes(ivec2(i, j))) * w);
          if (!inside(pixel)) continue;
          vec3 c = in_view(ivec2(i, j), pixel);
          mean += c, squares += c * c, count += 1.0;
        }
      if (count > 1.0) sum += dot(squares / count - mean * mean / (count * count), vec3(1.0));
    }
  return sum;
}

void main() {
  vec2 share = (gl_FragCoord.xy - u_offset) / u_output_size;
  vec2 s = u_window_centre + (share - 0.5) * u_window_size;
#if TASK == 0
  color = vec4(seen(s), 1.0);
#elif TASK == 1
  color = vec4(refocused(s), 1.0);
#elif TASK == 2
  // Rows are eyes through the zone, the leftmost on top; the views themselves where there are as many rows.
  s.y = u_window_centre.y + (0.5 - u_line) * u_window_size.y;
  float place = clamp((1.0 - share.y) * float(u_grid.x) - 0.5, 0.0, float(u_grid.x - 1));
  float up = clamp(view_places(slope_at(s)).y, 0.0, float(u_grid.y - 1));
  color = vec4(between_views(s, vec2(view_slope(u_across, place), view_slope(u_up, up)), vec2(place, up)), 1.0);
#elif DEPTH
  vec2 slope = slope_at(u_point);
  ivec2 view = ivec2(clamp(floor(view_places(slope) + 0.5), vec2(0.0), vec2(u_grid - 1)));
  color = vec4(meet(view, u_point, slope - view_slopes(view)).x);
#else
  color = vec4(disagreement(share.x));
#endif
#if SCREEN
  color.rgb = srgb(u_exposure * color.rgb);
#endif
}
`,rn=({overlay:e,layered:t})=>`#version 300 es
#define BY_ANGLE 0
#define OVERLAY ${Number(e)}
#define LAYERED ${Number(t)}
${Qt}
uniform sampler2D u_panel;  // a picture of its own
uniform vec2 u_output_size, u_panel_size;
uniform int u_kind;         // 0 integral, 1 quilt, 2 own
uniform vec4 u_part;        // what is shown of the panel: left, top, width, height, in pixels
uniform vec4 u_loupe;       // x, y, radius in pixels of the output from its top left; pixels of the output per panel pixel
uniform vec2 u_loupe_at;    // the panel pixel in its middle
out vec4 color;

vec3 panel_pixel(ivec2 p) {
  if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, ivec2(u_panel_size)))) return vec3(0.0);
  if (u_kind == 2) return texelFetch(u_panel, p, 0).rgb;
  if (u_kind == 1) {
    // A quilt's padding at the top and right is not sent.
    ivec2 q = p - ivec2(0, int(u_panel_size.y) - u_tiles.y * int(u_view_size.y));
    if (q.y < 0 || q.x >= u_tiles.x * int(u_view_size.x)) return vec3(0.0);
    vec2 column_row = floor((vec2(q) + 0.5) / u_view_size), pixel = vec2(q) - column_row * u_view_size;
    vec3 tile = place_of_tile(column_row, u_view_size, vec2(u_tiles)), seen = texel_of(u_views, tile, pixel).rgb;
#if OVERLAY
    seen = with_origin(seen, tile, pixel);
#endif
    return seen;
  }
  // Lenses turn their pixels round: the rightmost is seen from the left, the topmost from below.
  ivec2 cell = p / u_grid, in_cell = p - cell * u_grid;
  ivec2 view = ivec2(u_grid.x - 1 - in_cell.x, in_cell.y);
  if (u_grid.y == 1) view.y = 0;
  return in_view(view, vec2(cell) + 0.5);
}

void main() {
  vec2 at = vec2(gl_FragCoord.x, u_output_size.y - gl_FragCoord.y);
  vec2 panel = u_part.xy + at / u_output_size * u_part.zw;
  vec2 from_loupe = at - u_loupe.xy;
  float reach = max(abs(from_loupe.x), abs(from_loupe.y));
  if (u_loupe.z > 0.0 && reach < u_loupe.z) {
    vec2 place = u_loupe_at + from_loupe / u_loupe.w;
    vec3 c = panel_pixel(ivec2(floor(place)));
    if (u_kind == 0) {
      vec2 to_edge = abs(fract(place / vec2(u_grid) + 0.5) - 0.5) * vec2(u_grid) * u_loupe.w;
      bool marked = ivec2(floor(place / vec2(u_grid))) == ivec2(floor(u_loupe_at / vec2(u_grid)));
      bool edge = to_edge.x < 1.0 || (u_grid.y > 1 && to_edge.y < 1.0);
      if (edge) c = mix(c, marked ? vec3(1.0, 0.55, 0.05) : vec3(0.5), 0.8);
      else if (!marked) c *= 0.45;
    }
    color = vec4(reach > u_loupe.z - 1.5 ? vec3(0.6) : c, 1.0);
    return;
  }
  // A panel that is shown smaller than it is: the mean of its pixels, a few of each.
  vec2 size = u_part.zw / u_output_size;
  vec3 sum = vec3(0.0);
  int n = clamp(int(ceil(max(size.x, size.y))), 1, 4);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      sum += panel_pixel(ivec2(floor(panel + ((vec2(i, j) + 0.5) / float(n) - 0.5) * size)));
  color = vec4(sum / float(n * n), 1.0);
}
`,an=`#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D u_frame;
out vec4 color;
void main() { color = texelFetch(u_frame, ivec2(gl_FragCoord.xy), 0); }
`,on=`#version 300 es
uniform mat4 u_clip_from_display;
uniform vec2 u_window_centre, u_window_size;  // mm
out vec2 share;
void main() {
  share = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = u_clip_from_display * vec4(u_window_centre + (share - 0.5) * u_window_size, 0.0, 1.0);
}
`,sn=`#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D u_first;
uniform float u_exposure;
in vec2 share;
out vec4 color;
${tn}
void main() { color = vec4(srgb(u_exposure * texture(u_first, share).rgb), 1.0); }
`,cn=[`first`,`anaglyph`,`wipe`,`difference`,`beside`,`above`],ln=e=>`#version 300 es
#define MODE ${cn.indexOf(e)}
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D u_first, u_second;
uniform vec4 u_place;    // where the picture lies on the canvas: left, bottom, width, height, pixels
uniform float u_wipe, u_exposure, u_scale;
uniform vec3 u_ground;
out vec4 color;

${tn}
vec3 first(vec2 at) { return srgb(u_exposure * texture(u_first, at).rgb); }
vec3 second(vec2 at) { return srgb(u_exposure * texture(u_second, at).rgb); }

#if MODE == 3
// From black through blue, red and yellow to white; even in lightness.
vec3 heat(float t) {
  vec3 c = mix(vec3(0.01, 0.01, 0.06), vec3(0.16, 0.12, 0.55), smoothstep(0.0, 0.25, t));
  c = mix(c, vec3(0.72, 0.15, 0.42), smoothstep(0.2, 0.5, t));
  c = mix(c, vec3(0.98, 0.60, 0.12), smoothstep(0.45, 0.75, t));
  return mix(c, vec3(1.0, 0.98, 0.85), smoothstep(0.7, 1.0, t));
}
#endif

void main() {
  vec2 at = (gl_FragCoord.xy - u_place.xy) / u_place.zw;
  if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) {
    color = vec4(u_ground, 1.0);
    return;
  }
  vec3 c;
#if MODE == 1
    // Red from the left eye's brightness, which strains the eyes less than its red alone.
    c = vec3(dot(first(at), vec3(0.299, 0.587, 0.114)), second(at).gb);
#elif MODE == 2
    c = at.x < u_wipe ? first(at) : second(at);
    if (abs(at.x - u_wipe) * u_place.z < 1.0) c = vec3(1.0);
#elif MODE == 3
    vec3 d = abs(first(at) - second(at)) * 255.0;
    c = heat(clamp(max(d.r, max(d.g, d.b)) / u_scale, 0.0, 1.0));
#elif MODE == 4
    c = at.x < 0.5 ? first(vec2(2.0 * at.x, at.y)) : second(vec2(2.0 * at.x - 1.0, at.y));
#elif MODE == 5
    c = at.y > 0.5 ? first(vec2(at.x, 2.0 * at.y - 1.0)) : second(vec2(at.x, 2.0 * at.y));
#else
  c = first(at);
#endif
  color = vec4(c, 1.0);
}
`,un={stays:0,repeats:1,"next lens":2},dn={integral:0,quilt:1,own:2},fn={off:`first`,anaglyph:`anaglyph`,"side-by-side":`beside`,"top-bottom":`above`},pn={first:`first`,second:`first`,wipe:`wipe`,difference:`difference`,"side-by-side":`beside`},mn=92,hn=800,J=e=>e.show===`eye`&&e.crosstalk>0&&e.aperture===0?`eye/${Math.round(100*e.crosstalk)}`:e.show,gn=e=>[e.first,e.step,+(e.by===`angle`),un[e.beyond]],_n=class{constructor(e,t,n){this.gl=e,this.fields=t,this.frames=n,this.screen=[1,1],this.place={left:0,top:0,width:1,height:1},this.drawn=this.place,this.loupe=null,this.eyePrograms=new Map,this.panelPrograms=new Map,this.frameProgram=null,this.windowProgram=null,this.screenPrograms=new Map,this.direct=!1,this.last=null,this.targets=[new H(e),new H(e),new H(e),new H(e)]}frameOf(e,t){if(e===0)return t;let n=this.fields[e].frames,r=n.findIndex(e=>e.label===this.fields[0].frames[t].label);return r>=0?r:Math.min(t,n.length-1)}shownFields(e){return this.fields.length<2||e.compare===`first`||e.show===`display`?[0]:e.compare===`second`?[1]:[0,1]}draw(e,t,n=1){let r=this.shownFields(e),i=r.map(t=>this.loaded(t,e));if(i.some(e=>!e))return!1;if(r.forEach((t,n)=>this.wantOverlay(t,i[n],e)),e.show===`display`)return this.drawFrame(i[0]);let a=r.length===1&&e.show===`eye`&&e.stereo!==`off`,o=this.fields[r[0]];this.layOut(o,e,a,r.length>1);let s=a||r.length>1;this.resize(n);let c=this.pictureSize(o,e,s),l=c.map(e=>Math.max(1,Math.round(e/n)));return this.direct=!s&&e.show===`eye`&&c[0]===this.place.width&&c[1]===this.place.height,this.last={state:{...e},field:o,frame:i[0]},this.direct?(this.drawDirectly(o,i[0],e,t),e.line>=0&&this.drawLine(o,i[0],e),!0):(r.forEach((t,n)=>{let r=i[n];e.show===`panel`?this.drawPanel(this.targets[n],this.fields[t],r,e):a?this.drawPair(o,r,e,l):this.drawEye(this.targets[n],this.fields[t],r,e,e.eye,l)}),this.compose(e,a,t),e.line>=0&&e.show===`eye`&&this.drawLine(o,i[0],e),!0)}wantOverlay(e,t,n){n.overlay!==`none`&&n.show!==`display`&&this.fields[e].provenance&&this.frames.wantProvenance(t,e,this.frameOf(e,n.frame))}showsDifference(e){return this.shownFields(e).length>1&&e.compare===`difference`}overlays(e,t){return t.overlay!==`none`&&!this.showsDifference(t)&&!!e.provenance}originShares(e){let t=this.shownFields(e)[0];return this.frames.peek(t,this.frameOf(t,e.frame),J(e))?.provenance?.shares??null}overlayUniforms(e,t,n){return{u_provenance:G(this.gl,3,t.provenance?.texture??t.views,t.layer),u_tints:Ct(e,n.overlay)}}loaded(e,t){return this.frames.get(e,this.frameOf(e,t.frame),J(t))}drawFrame(e){let t=this.gl,{width:n,height:r}=t.canvas;return this.place={left:0,top:0,width:n,height:r},this.last=null,t.bindFramebuffer(t.FRAMEBUFFER,null),t.viewport(0,0,n,r),this.frameProgram??=new z(t,an),this.frameProgram.draw({u_frame:B(t,0,e.panel)}),!0}drawHeadset(e,t,n,r){let i=this.gl;i.bindFramebuffer(i.FRAMEBUFFER,t),i.clearColor(r[0],r[1],r[2],1),i.clear(i.COLOR_BUFFER_BIT);let a={...e,show:`eye`},[o]=this.shownFields(a),s=this.loaded(o,a);for(let e of n)s&&e.eye[2]>1&&this.drawWindow(this.fields[o],s,a,e)}drawWindow(e,t,n,r){let i=this.gl,{x:a,y:o,width:s,height:c}=r.viewport,l=this.targets[0];this.drawEye(l,e,t,n,r.eye,this.windowSize(e,Math.max(s,c))),i.bindFramebuffer(i.FRAMEBUFFER,r.framebuffer),i.viewport(a,o,s,c),this.windowProgram??=new z(i,sn,on);let u={u_clip_from_display:r.clipFromDisplay,u_window_centre:e.window_mm.centre,u_window_size:e.window_mm.size};this.windowProgram.draw({...u,u_first:B(i,0,l.texture),u_exposure:2**n.exposure},4)}windowSize(e,t){let[n,r]=e.window_mm.size,i=Math.min(t,Math.max(...m(e),hn))/Math.max(n,r);return[Math.max(1,Math.round(n*i)),Math.max(1,Math.round(r*i))]}canvasCodes(){let e=this.gl,{width:t,height:n}=e.canvas,r=new Uint8ClampedArray(4*t*n);e.bindFramebuffer(e.FRAMEBUFFER,null),e.readPixels(0,0,t,n,e.RGBA,e.UNSIGNED_BYTE,new Uint8Array(r.buffer));for(let e=0;e<n>>1;e++){let i=r.slice(4*t*e,4*t*(e+1));r.copyWithin(4*t*e,4*t*(n-1-e),4*t*(n-e)),r.set(i,4*t*(n-1-e))}return r}drawPair(e,t,n,r){[-.5,.5].forEach((i,a)=>{let[o,s,c]=n.eye;this.drawEye(this.targets[a],e,t,n,[o+i*n.separation,s,c],r)})}resize(e){let{canvas:t}=this.gl,n=t=>Math.round(t/e),[r,i]=this.screen.map(e=>Math.max(1,n(e)));(t.width!==r||t.height!==i)&&Object.assign(t,{width:r,height:i});let{left:a,top:o}=this.place;this.drawn={left:n(a),top:n(o),width:Math.max(1,n(this.place.width)),height:Math.max(1,n(this.place.height))}}layOut(e,t,n,r){let[i,a]=this.screen,o=a*(t.line>=0&&t.show===`eye`?.8:1),[s,c]=t.show===`panel`?e.panel.size:e.window_mm.size,l=n&&t.stereo===`side-by-side`||r&&t.compare===`side-by-side`,u=n&&t.stereo===`top-bottom`,d=s/c*(l?2:1)/(u?2:1),f=Math.min(i/d,o),p={width:Math.round(f*d),height:Math.round(f)};this.place={left:Math.round((i-p.width)/2),top:Math.round((o-p.height)/2),...p}}pictureSize(e,t,n){let[r,i]=e.window_mm.size,a=Math.max(...m(e)),o=n&&(t.stereo===`top-bottom`||t.compare===`side-by-side`),s=Math.max(this.place.width,this.place.height)/(o?2:1),c=Math.max(2,Math.min(s,Math.max(a,hn)));if(!n&&c===s)return[this.place.width,this.place.height];let l=c/Math.max(r,i);return[Math.max(1,Math.round(r*l)),Math.max(1,Math.round(i*l))]}fieldUniforms(e,t){let n=this.gl;return{u_views:G(n,0,t.views,t.layer),u_depth:G(n,1,t.depth??t.views,t.layer),u_panel:B(n,2,t.panel),u_layer_tiles:{integers:t.layer??e.tiles},u_view_size:t.viewSize,u_tiles:{integers:e.tiles},u_grid:{integers:[e.across.views,e.up.views]},u_window_centre:e.window_mm.centre,u_window_size:e.window_mm.size,u_across:gn(e.across),u_up:gn(e.up),u_vergence:e.vergence_per_mm,u_disparity_scale:e.disparity_scale_mm}}eyeProgram(e,t,n,r={}){let i={byAngle:e.across.by===`angle`||e.up.by===`angle`,rows:e.up.views>1,depth:!1,task:n,layered:t.layer!==null,screen:!1,snap:!1,crosstalk:!1,budget:!1,overlay:!1,...r},a=JSON.stringify(i),o=this.eyePrograms.get(a)??new z(this.gl,nn(i));return this.eyePrograms.set(a,o),o}usesDepth(e,t){return(t.between===`depth`||t.budget)&&e.depth!==null&&!t.lenses&&t.crosstalk===0}eyeUniforms(e,t,n,r,i){let a=e.lens_samples.map(e=>e&&n.lenses?1:0);return{...this.fieldUniforms(e,t),...this.overlays(t,n)?this.overlayUniforms(e,t,n):{},u_output_size:i,u_offset:[0,0],u_exposure:2**n.exposure,u_eye:r,u_snap:{integers:a},u_disparities:t.disparities,u_aperture:n.aperture,u_focus:p(e,n.focus),u_line:n.line,u_sigma:n.crosstalk,u_budget:Math.min(e.depth_budget_mm??1e9,1e9)}}drawDirectly(e,t,n,r){let i=this.gl,{left:a,top:o,width:s,height:c}=this.drawn,l=i.canvas.height-o-c;i.bindFramebuffer(i.FRAMEBUFFER,null),i.viewport(0,0,i.canvas.width,i.canvas.height),i.clearColor(r[0],r[1],r[2],1),i.clear(i.COLOR_BUFFER_BIT),i.viewport(a,l,s,c);let[u,d]=this.eyePass(e,t,n,n.eye,[s,c],!0);u.draw({...d,u_offset:[a,l]})}eyePass(e,t,n,r,i,a){let o=n.aperture>0?`refocus`:`eye`,s=o===`eye`&&n.crosstalk>0&&te(e),c=o===`eye`&&this.usesDepth(t,n);return[this.eyeProgram(e,t,o,{depth:c,screen:a,snap:n.lenses,crosstalk:s,budget:c&&n.budget,overlay:this.overlays(t,n)}),this.eyeUniforms(e,t,n,r,i)]}drawEye(e,t,n,r,i,a){e.begin(...a);let[o,s]=this.eyePass(t,n,r,i,a,!1);o.draw(s)}panelProgram(e){let t=JSON.stringify(e),n=this.panelPrograms.get(t)??new z(this.gl,rn(e));return this.panelPrograms.set(t,n),n}drawPanel(e,t,n,r){let{width:i,height:a}=this.place,o=this.gl.canvas.width/this.gl.canvas.clientWidth;e.begin(i,a);let s=this.loupe&&{x:this.loupe.x-this.place.left,y:this.loupe.y-this.place.top},[c,l]=t.panel.size,u=t.panel.is===`integral`?Math.max(t.across.views,t.up.views):8,d=mn*o,f=this.overlays(n,r);this.panelProgram({overlay:f,layered:n.layer!==null}).draw({...this.fieldUniforms(t,n),...f?this.overlayUniforms(t,n,r):{},u_output_size:[i,a],u_panel_size:t.panel.size,u_kind:{integers:[dn[t.panel.is]]},u_part:[0,0,c,l],u_loupe:s?[s.x,s.y,d,Math.max(2*o,Math.floor(1.6*d/(2*u)))]:[0,0,0,1],u_loupe_at:s?[s.x/i*c,s.y/a*l]:[0,0]})}screenUniforms(e,t){return{u_first:B(this.gl,0,this.targets[0].texture),u_second:B(this.gl,1,this.targets[1].texture),u_exposure:2**e.exposure,u_wipe:e.wipe,u_scale:e.scale,u_ground:t}}screenProgram(e){let t=this.screenPrograms.get(e)??new z(this.gl,ln(e));return this.screenPrograms.set(e,t),t}compose(e,t,n){let r=this.gl,{width:i,height:a}=r.canvas;r.bindFramebuffer(r.FRAMEBUFFER,null),r.viewport(0,0,i,a);let o=`first`;t?o=fn[e.stereo]:this.shownFields(e).length>1&&(o=pn[e.compare]);let s=this.drawn;this.screenProgram(o).draw({...this.screenUniforms(e,n),u_place:[s.left,a-s.top-s.height,s.width,s.height]})}drawLine(e,t,n){let r=this.gl,{width:i,height:a}=r.canvas,{left:o,width:s}=this.drawn,c=[s,Math.max(8,Math.round(a*.18))],l=this.targets[2];l.begin(...c),this.eyeProgram(e,t,`line`,{depth:this.usesDepth(t,n),overlay:this.overlays(t,n)}).draw(this.eyeUniforms(e,t,n,n.eye,c)),r.bindFramebuffer(r.FRAMEBUFFER,null),r.viewport(o,0,...c),this.screenProgram(`first`).draw({...this.screenUniforms(n,[0,0,0]),u_first:B(r,0,l.texture),u_place:[o,0,...c]}),r.viewport(0,0,i,a)}shareAt(e,t,n){let r=[(t-this.place.left)/this.place.width,(n-this.place.top)/this.place.height];if(r.some(e=>e<0||e>1))return null;let i=e=>2*e%1,a=this.shownFields(e).length>1;return(a?e.compare===`side-by-side`:e.stereo===`side-by-side`&&e.show===`eye`)&&(r=[i(r[0]),r[1]]),!a&&e.stereo===`top-bottom`&&e.show===`eye`&&(r=[r[0],i(r[1])]),r}valueAt(e,t){if(this.last&&(this.direct||this.overlays(this.last.frame,this.last.state)&&this.last.state.show===`eye`))return this.valueOfEye(t);let n=this.targets[e],r=Math.min(n.width-1,Math.floor(t[0]*n.width)),i=Math.min(n.height-1,Math.floor((1-t[1])*n.height));return[...n.read(r,i,1,1)].slice(0,3)}valueOfEye(e){let{field:t,frame:n}=this.last,r={...this.last.state,overlay:`none`},{width:i,height:a}=this.place,o=Math.min(i-1,Math.floor(e[0]*i)),s=Math.min(a-1,Math.floor((1-e[1])*a)),c=this.targets[3];c.begin(1,1);let[l,u]=this.eyePass(t,n,r,r.eye,[i,a],!1);return l.draw({...u,u_offset:[-o,-s]}),[...c.read(0,0,1,1)].slice(0,3)}depthAt(e,t){let n=this.fields[this.shownFields(e)[0]],r=this.loaded(this.shownFields(e)[0],e);if(!r||n.across.views*n.up.views<2)return null;let i=r.depth?1:128,{centre:a,size:o}=n.window_mm,s=[a[0]+(t[0]-.5)*o[0],a[1]+(.5-t[1])*o[1]],c=this.targets[3];c.begin(i,1);let l=this.eyeUniforms(n,r,e,e.eye,[i,1]);this.eyeProgram(n,r,`find`,{depth:r.depth!==null}).draw({...l,u_point:s});let u=c.read(0,0,i,1),[d,f]=r.disparities,p=u[0];if(!r.depth){let e=0;for(let t=1;t<i;t++)u[4*t]<u[4*e]&&(e=t);p=d+(e+.5)/i*(f-d)}return p/(1+p*n.vergence_per_mm)}picture(e,t,n){let r=this.loaded(t,{...e,show:`eye`});if(!r)return null;let i=this.targets[3];this.drawEye(i,this.fields[t],r,e,e.eye,n);let a=i.read(0,0,...n),o=new Uint8ClampedArray(a.length),s=2**e.exposure,[c,l]=n;for(let e=0;e<l;e++)for(let t=0;t<4*c;t++){let n=a[4*c*(l-1-e)+t];o[4*c*e+t]=t%4==3?255:vt(s*n)}return o}},vn={show:[`eye`,`panel`,`display`],stereo:[`off`,`anaglyph`,`side-by-side`,`top-bottom`],between:[`depth`,`blend`],overlay:[`none`,`provenance`,`missed`],compare:[`first`,`second`,`wipe`,`side-by-side`,`difference`],drag:[`eye`,`turn`,`plane`],theme:[`dark`,`light`]},yn={aperture:[0,1],separation:[0,200],exposure:[-8,8],crosstalk:[0,8],line:[-1,1],wipe:[0,1],scale:[1,255],speed:[.05,16]};function bn(e,t,n=!1){let r=e[0];return{frame:0,eye:[...r.eye_mm],aperture:0,focus:0,show:t?`display`:`eye`,stereo:`off`,separation:xn(r),between:r.depth?`depth`:`blend`,lenses:!1,crosstalk:0,exposure:0,line:-1,overlay:`none`,compare:e.length>1?`wipe`:`first`,wipe:.5,scale:32,speed:1,loop:!0,drag:t&&n?`turn`:`eye`,budget:!1,theme:`dark`}}function xn(e){let t=Math.abs(e.across.step)*e.across.views*e.eye_mm[2];return Math.min(63,Math.round(t*1.25)/10)}function Sn(e,t,n,r){if(e===`eye`){let e=typeof t==`string`?t.split(`,`).map(Number):t;return Array.isArray(e)&&e.length===3&&e.every(e=>Number.isFinite(e)&&Math.abs(e)<1e6)&&e[2]>=1?e:void 0}if(typeof r==`boolean`)return t===!0||t===`1`?!0:t===!1||t===`0`?!1:void 0;if(typeof r==`string`)return vn[e]?.includes(String(t))?t:void 0;let i=t===``||t===null?NaN:Number(t);if(!Number.isFinite(i))return;if(e===`frame`)return Math.min(Math.max(Math.round(i),0),n[0].frames.length-1);if(e===`focus`)return i*n[0].vergence_per_mm<.95?i:void 0;let a=yn[e];return a?Math.min(Math.max(i,a[0]),a[1]):i}var Cn=class{constructor(e,t=!1,n=t,r=!1){this.fields=e,this.plays=t,this.listeners=[],this.addressTimer=0,this.defaults=bn(e,n,r),this.state={...this.defaults},this.readAddress()}listen(e){this.listeners.push(e)}touch(){this.listeners.forEach(e=>e())}set(e){let t=!1;for(let[n,r]of Object.entries(e)){if(!(n in this.state)||n===`show`&&r===`display`&&!this.plays)continue;let e=n,i=Sn(e,r,this.fields,this.state[e]);i!==void 0&&JSON.stringify(i)!==JSON.stringify(this.state[e])&&(this.state[e]=i,t=!0)}t&&(this.touch(),window.clearTimeout(this.addressTimer),this.addressTimer=window.setTimeout(()=>this.writeAddress(),250))}reset(){this.set({...this.defaults,eye:this.fields[0].eye_mm,frame:this.state.frame,theme:this.state.theme})}readAddress(){this.set(Object.fromEntries(new URLSearchParams(location.hash.slice(1))))}address(){let e=new URLSearchParams;for(let t of Object.keys(this.state)){let n=this.state[t];if(JSON.stringify(n)===JSON.stringify(this.defaults[t]))continue;let r=e=>String(Math.round(e*1e4)/1e4);e.set(t,Array.isArray(n)?n.map(r).join(`,`):typeof n==`boolean`?n?`1`:`0`:typeof n==`number`?r(n):n)}return`#${e.toString().replace(/%2C/g,`,`)}`}writeAddress(){try{history.replaceState(null,``,this.address())}catch{}}},wn=2e3,Y=Math.PI/180;function Tn({alpha:e,beta:t,gamma:n}){let[r,i,a]=[e,t,n].map(e=>Math.cos(e*Y)),[o,s,c]=[e,t,n].map(e=>Math.sin(e*Y));return[[r*a-o*s*c,-o*i,r*c+o*s*a],[o*a+r*s*c,r*i,o*c-r*s*a],[-i*c,s,i*a]]}var En=(e,t)=>e.map(e=>e[0]*t[0]+e[1]*t[1]+e[2]*t[2]),Dn=(e,t)=>[0,1,2].map(n=>e[0][n]*t[0]+e[1][n]*t[1]+e[2][n]*t[2]);function On([e,t,n],r){let[i,a]=[Math.cos(r*Y),Math.sin(r*Y)];return[e*i-t*a,e*a+t*i,n]}function kn(e,t,n,r=0){let i=On([n[0],n[1],1],-r),[a,o,s]=On(Dn(Tn(t),En(Tn(e),i)),r);return s>.05?[a/s,o/s]:null}var An=class{constructor(e,t,n,r){this.slopes=e,this.move=t,this.changed=n,this.notify=r,this.isThere=!1,this.isOn=!1,this.from=null,window.addEventListener(`deviceorientation`,e=>this.take(e)),typeof DeviceOrientationEvent<`u`&&(this.isThere=`requestPermission`in DeviceOrientationEvent&&navigator.maxTouchPoints>0)}async toggle(){if(!this.isOn&&!await this.mayRead())return this.notify(`The browser does not let this page read how the device is held.`);this.notify(``),this.isOn=!this.isOn,this.from=null,this.changed(),window.setTimeout(()=>this.giveUpWithoutSensor(),wn)}giveUpWithoutSensor(){this.isOn&&!this.from&&(this.isOn=this.isThere=!1,this.notify(`This device does not tell how it is held.`),this.changed())}async mayRead(){let{requestPermission:e}=DeviceOrientationEvent;try{return!e||await e.call(DeviceOrientationEvent)===`granted`}catch{return!1}}take({alpha:e,beta:t,gamma:n}){if(t===null||n===null)return;let r={alpha:e??0,beta:t,gamma:n};if(this.isThere||(this.isThere=!0,this.changed()),!this.isOn)return;this.from??={turn:r,slopes:this.slopes()};let i=kn(this.from.turn,r,this.from.slopes,screen.orientation?.angle??0);i&&this.move(i)}},jn=`http://www.w3.org/2000/svg`,Mn=40;function X(e,t){let n=document.createElementNS(jn,e);for(let[e,r]of Object.entries(t))n.setAttribute(e,String(r));return n}var Nn={play:`M4 2.5v11l9-5.5z`,pause:`M4 3h3v10H4zM9 3h3v10H9z`,back:`M11.5 3v10L5 8zM3.5 3H5v10H3.5z`,forward:`M4.5 3v10L11 8zM11 3h1.5v10H11z`,loop:`M4 4.5h6.5A2.5 2.5 0 0 1 13 7v2a2.5 2.5 0 0 1-2.5 2.5H5.2L6.7 13l-.9.9L2.7 11l3.1-3 .9.9-1.5 1.4h5.3A1.3 1.3 0 0 0 11.8 9V7a1.3 1.3 0 0 0-1.3-1.3H4z`};function Z(e,t){let n=document.createElement(`button`);return n.type=`button`,n.className=`icon`,Pn(n,e,t),n}function Pn(e,t,n){if(e.getAttribute(`aria-label`)===t)return;e.setAttribute(`aria-label`,t),e.title=t;let r=X(`svg`,{viewBox:`0 0 16 16`,"aria-hidden":`true`});r.append(X(`path`,{d:Nn[n]})),e.replaceChildren(r)}function Fn(e){let t=[];return e.forEach((n,r)=>{n.pending&&(r>0&&e[r-1].pending?t[t.length-1][1]=r:t.push([r,r]))}),t}var In=class{constructor(e,t,n){this.parent=e,this.store=t,this.isReady=n,this.playing=!1,this.scrub=document.createElement(`input`),this.label=document.createElement(`output`),this.speed=document.createElement(`select`),this.startedAt=0,this.startFrame=0;let{frames:r}=t.fields[0];this.psnr=r.map(e=>e.psnr_db),this.play=Z(`Play`,`play`),this.loop=Z(`Loop`,`loop`),this.marks=X(`svg`,{class:`marks`,role:`img`}),r.length<2||(this.build(r.length),t.listen(()=>this.update()),this.update())}build(e){let t=Z(`Previous frame`,`back`),n=Z(`Next frame`,`forward`);Object.assign(this.scrub,{type:`range`,min:`0`,max:String(e-1),step:`1`}),this.scrub.setAttribute(`aria-label`,`Frame`),this.speed.setAttribute(`aria-label`,`Speed`);for(let e of[.1,.25,.5,1,2,4])this.speed.append(new Option(`${e}\u00d7`,String(e)));this.play.addEventListener(`click`,()=>this.toggle()),t.addEventListener(`click`,()=>this.step(-1)),n.addEventListener(`click`,()=>this.step(1)),this.loop.addEventListener(`click`,()=>this.store.set({loop:!this.store.state.loop})),this.speed.addEventListener(`change`,()=>this.store.set({speed:Number(this.speed.value)})),this.scrub.addEventListener(`input`,()=>this.goTo(Number(this.scrub.value))),this.marks.addEventListener(`click`,t=>{let n=this.marks.getBoundingClientRect();this.goTo(Math.round((t.clientX-n.left)/n.width*(e-1)))});let r=document.createElement(`div`);r.className=`track`,r.append(this.marks,this.scrub),this.parent.append(this.play,t,n,r,this.label,this.loop,this.speed),this.parent.hidden=!1}toggle(){this.store.fields[0].frames.length<2||(this.playing=!this.playing,this.start(),this.update())}pause(){this.playing&&this.toggle()}step(e){let t=this.store.fields[0].frames.length;this.playing=!1,this.store.set({frame:this.finishedFrom((this.store.state.frame+e+t)%t,e)}),this.update()}finishedFrom(e,t){let{frames:n}=this.store.fields[0],r=r=>((e+r*t)%n.length+n.length)%n.length,i=n.findIndex((e,t)=>!n[r(t)].pending);return i<0?e:r(i)}takeFrames(){this.store.fields[0].frames.forEach((e,t)=>this.psnr[t]=e.psnr_db),this.psnr.length>1&&this.update()}goTo(e){this.store.set({frame:e}),this.start()}start(){this.startedAt=performance.now(),this.startFrame=this.store.state.frame}tick(e){if(!this.playing)return;let{state:t,fields:n}=this.store,r=n[0].frames.length,i=Math.max(e-this.startedAt,0)/1e3,a=this.startFrame+Math.floor(i*n[0].frames_per_second*t.speed);if(a!==t.frame){if(a>=r&&!t.loop)this.playing=!1,a=r-1,this.store.set({frame:a}),this.update();else if(a%=r,n[0].frames[a].pending){let e=this.finishedFrom(a,1);e!==t.frame&&this.store.set({frame:e}),this.start()}else if(this.isReady(a))this.store.set({frame:a});else{let e=(t.frame+1)%r;this.isReady(e)&&this.store.set({frame:e}),this.start()}}}update(){let{state:e,fields:t}=this.store,{frames:n}=t[0];Pn(this.play,this.playing?`Pause`:`Play`,this.playing?`pause`:`play`),this.loop.setAttribute(`aria-pressed`,String(e.loop)),this.scrub.value=String(e.frame);let r=n[e.frame].kind,i=this.psnr[e.frame],a=i!==void 0&&Number.isFinite(i)?`\n${i.toFixed(1)} dB`:``;this.label.value=`${n[e.frame].label} / ${n[n.length-1].label}${a}`,this.scrub.setAttribute(`aria-valuetext`,`frame ${n[e.frame].label}${r?`, ${r}`:``}${i===void 0?``:`, ${i.toFixed(1)} dB`}`),this.label.title=[r&&`${r} frame`,i!==void 0&&`${i.toFixed(2)} dB`].filter(Boolean).join(`, `);let o=String(e.speed);[...this.speed.options].some(e=>e.value===o)||this.speed.append(new Option(`${o}\u00d7`,o)),this.speed.value=o,this.drawMarks()}drawMarks(){let{frames:e}=this.store.fields[0],t=this.psnr.filter(e=>e!==void 0&&Number.isFinite(e)),n=t.length>1,r=n?Mn:8,i=e.length-1;this.marks.setAttribute(`viewBox`,`0 0 ${i} ${r}`),this.marks.setAttribute(`preserveAspectRatio`,`none`),this.marks.style.height=`${r}px`;let a=[];e.forEach((e,t)=>{e.kind===`key`&&a.push(X(`line`,{x1:t,x2:t,y1:r-6,y2:r,class:`key`}))});let o=e.filter(e=>e.pending).length,s=a.length>0?`${a.length} key frames are marked.`:`Frames.`;if(n){let e=Math.min(...t),n=Math.max(...t,e+1),i=t=>3+(1-(t-e)/(n-e))*(r-12),o=this.psnr.map((e,t)=>e===void 0||!Number.isFinite(e)?null:`${t},${i(e).toFixed(2)}`);a.push(X(`polyline`,{points:o.filter(Boolean).join(` `),class:`curve`})),s+=` PSNR from ${e.toFixed(1)} to ${Math.max(...t).toFixed(1)} dB.`}o>0&&(a.unshift(...Fn(e).map(([e,t])=>X(`rect`,{x:Math.max(e-.5,0),y:0,width:Math.min(t+.5,i)-Math.max(e-.5,0),height:r,class:`pending`}))),s+=` ${e.length-o} of ${e.length} frames are rendered.`);let c=this.store.state.frame;n&&a.push(X(`line`,{x1:c,x2:c,y1:0,y2:r,class:`now`}));let l=X(`title`,{});l.textContent=s,this.marks.replaceChildren(l,...a),this.marks.setAttribute(`aria-label`,s)}},Ln=()=>navigator.xr,Rn=()=>window.XRWebGLLayer,zn=600,Bn=e=>Math.max(1,zn/e.eye_mm[2]);function Vn(e,t){let n=(n,r)=>[0,1,2,3].reduce((i,a)=>i+e[4*a+n]*t[4*r+a],0);return[...Array(16).keys()].map(e=>n(e%4,e>>2))}var Hn=class{constructor(e,t,n,r,i){this.gl=e,this.field=t,this.drawViews=n,this.changed=r,this.notify=i,this.isThere=!1,this.session=null,Ln()?.addEventListener(`devicechange`,()=>void this.look()),this.look()}get isOn(){return this.session!==null}async toggle(){this.notify(``);try{this.session?await this.session.end():await this.enter()}catch(e){this.notify(`The headset cannot be entered: ${e instanceof Error?e.message:String(e)}`)}}async look(){let e=Ln();this.isThere=await e?.isSessionSupported(`immersive-vr`).catch(()=>!1)??!1,this.changed()}async enter(){let t=Ln(),n=Rn();if(!t||!n)throw new e(`this browser has no WebXR.`);let r=await t.requestSession(`immersive-vr`);try{await this.begin(r,n)}catch(e){throw await r.end().catch(()=>{}),e}}async begin(e,t){await this.gl.makeXRCompatible();let n=new t(e,this.gl);e.updateRenderState({baseLayer:n});let r=await e.requestReferenceSpace(`local`);e.addEventListener(`end`,()=>this.leave(e)),this.session=e;let i=(t,a)=>{this.session===e&&(e.requestAnimationFrame(i),this.drawFrame(t,n,a.getViewerPose(r)?.views??[]))};e.requestAnimationFrame(i),this.changed()}leave(e){this.session===e&&(this.session=null,this.changed())}drawFrame(e,t,n){let r=n.flatMap(e=>{let n=t.getViewport(e);return n?[{framebuffer:t.framebuffer,viewport:n,eye:this.eyeOf(e),clipFromDisplay:this.clipFromDisplay(e)}]:[]});this.drawViews(e,t.framebuffer,r)}eyeOf(e){let t=1e3/Bn(this.field),{x:n,y:r,z:i}=e.transform.position,[a,o,s]=this.field.eye_mm;return[a+t*n,o+t*r,s+t*i]}clipFromDisplay(e){let t=Bn(this.field)/1e3,[n,r,i]=this.field.eye_mm.map(e=>-e*t),a=[t,0,0,0,0,t,0,0,0,0,t,0,n,r,i,1];return Vn(e.projectionMatrix,Vn(e.transform.inverse.matrix,a))}},Q=e=>document.getElementById(e);function Un(){let e=navigator.deviceMemory??4;return Math.min(Math.max(e*64,128),512)*1024*1024}function Wn(t){let n=Q(`failure`),r=t instanceof e?t.message:`The page failed: ${t instanceof Error?t.message:String(t)}`,i=document.createElement(`h2`);i.textContent=`This light field cannot be shown`;let a=document.createElement(`p`);a.textContent=r,n.replaceChildren(i,a),n.hidden=!1}function $(e){let{across:t,up:n,view_size:r}=e,i=t.views*n.views;return`${n.views>1?`${t.views}\u00d7${n.views} views`:`${i} view${i===1?``:`s`}`} of ${r[0]}\u00d7${r[1]}${e.depth?`, with depth`:``}`}function Gn({target:e,key:t}){return e instanceof HTMLButtonElement||e instanceof HTMLInputElement&&e.type===`checkbox`?t===` `:e instanceof HTMLInputElement&&e.type===`range`?t.startsWith(`Arrow`)||t===`Home`:e instanceof HTMLInputElement||e instanceof HTMLSelectElement}var Kn=class{constructor(e,t,n,r,{prints:i,drops:a}){this.fields=e,this.canvas=Q(`canvas`),this.wanted=!0,this.moved=!1,this.pace=new Ut,this.pointer=null,this.notices=new Map,this.prefetching=!1,this.eyeHome=``,this.updateControls=()=>{},this.run=r&&new ge(r,e[0],()=>this.hearOfRun(),(e,t)=>this.notify(e,t)),this.store=new Cn(e,t!==null,t!==null&&(n?.plays??!0),n!==null);let o=dt(this.canvas);this.frames=new It(o,e,Un(),()=>this.redraw(),e=>this.notify(`size`,e)),this.renderer=new _n(o,e,this.frames),this.timeline=new In(Q(`time`),this.store,e=>this.isThere(e)),this.live=n&&new Lt(n,e[0],this.frames,e=>this.hearOfScene(e),(e,t)=>this.notify(e,t)),this.print=i&&new Ne(i,e[0],this.frames,()=>this.store.state,e=>this.takeFacts(e),e=>this.hearOfPrint(e),(e,t)=>this.notify(e,t)),this.player=new Zt(o,this.store,this.frames,Q(`stage`),(e,t)=>this.notify(e,t),e=>void this.takePictures(e,a)),t&&this.beginPlaying(t),this.tilt=new An(()=>[0,1].map(e=>this.store.state.eye[e]/this.store.state.eye[2]),([t,n])=>this.moveEye(f(e[0].across,t),f(e[0].up,n)),()=>this.store.touch(),e=>this.notify(`tilt`,e)),this.headset=new Hn(o,e[0],(e,t,n)=>this.drawHeadset(e,t,n),()=>this.hearOfHeadset(),e=>this.notify(`headset`,e)),this.updateControls=ze(Q(`controls`),this.store,{save:()=>this.savePicture(),copy:()=>void this.copyLink(),focusRange:()=>this.focusRange(),player:this.player,tilt:this.tilt,headset:this.headset,live:this.live,run:this.run,print:this.print,savePrint:()=>this.print?.save(e[0].title)}),this.store.listen(()=>{this.moved=!0,this.outdate()}),this.store.listen(()=>this.live?.setFrame(this.store.state.frame)),this.store.listen(()=>this.print?.follow()),this.listen(),this.head(),this.run&&this.beginRun(),this.player.isPlaying&&!this.live&&this.timeline.toggle(),requestAnimationFrame(e=>this.tick(e))}async takePictures(t,n){try{let r=await t;if(!n)throw new e("To drop pictures, start `lippmann view` without a name.");await nt(r,e=>this.notify(`drop`,`The pictures are being read: ${Math.round(100*e)}\u2009%`))}catch(t){this.notify(`drop`,t instanceof e?t.message:String(t))}}beginPlaying(e){this.live?this.player.follow(e):this.player.playOn(e)}redraw(){this.wanted=!0}outdate(){Q(`stage`).dataset.drawn=`false`,this.redraw()}hearOfScene(e){let[t]=this.fields;this.followOthers(),this.eyeHome!==t.eye_mm.join()&&(this.eyeHome=t.eye_mm.join(),this.store.set({eye:t.eye_mm})),Q(`facts`).textContent=`${$({...t,depth:!1})}${this.progress()}`,Q(`facts`).title=this.live?.state?.depth.summary??``,Q(`stage`).dataset.rest=String(this.live?.isAtRest),Q(`stage`).dataset.outdated=String(this.live?.isOutdated),e&&this.outdate(),this.updateControls()}followOthers(){let e=this.live?.othersFrame??null;this.live?.isNew&&this.store.state.frame>0?this.live.setFrame(this.store.state.frame):e!==null&&!this.timeline.playing&&this.store.set({frame:e}),this.live?.state&&this.player.follow(this.live.state.display)}beginRun(){let{frames:e}=this.fields[0];e[this.store.state.frame].pending&&this.store.set({frame:Math.max(e.findIndex(e=>!e.pending),0)}),this.hearOfRun()}hearOfRun(){let e=this.run?.state.state===`finished`;Q(`facts`).textContent=e?$(this.fields[0]):this.run?.describe()??``,this.notify(`run`,this.run?.state.error??``),this.timeline.takeFrames(),this.updateControls(),this.redraw()}takeFacts(e){let[t]=this.fields,[n,r]=this.shares();Object.assign(t,e);let[,i,a]=t.eye_mm;this.store.set({eye:[d(t.across,n)*a,t.up.views>1?d(t.up,r)*a:i,a]})}hearOfPrint(e){let t=Q(`stage`);t.dataset.print=this.print?.isBusy?`making`:this.print?.isSeen?`shown`:``,this.canvas.style.cursor=this.print?.awaitsClick?`crosshair`:``,e&&(this.timeline.pause(),this.noticeOfAssumption(),Q(`facts`).textContent=this.print?.isSeen?`seen through the lenses of the print`:$(this.fields[0]),this.outdate()),this.updateControls()}progress(){let e=this.live?.state;if(!e||this.live?.isAtRest)return`, as rendered`;let t=this.live?.isOutdated?`, with the settings before`:``;return e.error?t:e.render?.state===`running`?`${t}, coarse while the job is rendered`:e.pass===``?`${t}, being set up`:`${t}, ${{coarse:`coarse`,draft:`draft`,final:`as rendered`}[e.pass]}: ${Math.round(100*e.share)}\u2009%`}head(){let e=this.fields.map(e=>e.title);document.title=`${e.join(` and `)} \u2013 Lippmann`,Q(`title`).textContent=e.join(` and `),Q(`facts`).textContent=$(this.fields[0]),this.noticeOfShapes(),this.noticeOfAssumption()}noticeOfAssumption(){let e=this.fields.some(e=>e.assumption)&&!this.print?.isSeen;this.notify(`assumption`,e?`Nothing says where the cameras stood: angles and depths are assumed.`:``)}noticeOfShapes(){let[e,t]=this.fields.map(e=>e.window_mm.size[0]/e.window_mm.size[1]);t!==void 0&&Math.abs(e/t-1)>.02&&this.notify(`shapes`,`Their displays differ in shape: the second is stretched to the first.`)}notify(e,t){t?this.notices.set(e,t):this.notices.delete(e);let n=[...this.notices.values()].join(` `),r=Q(`notice`);r.textContent!==n&&(r.textContent=n)}shown(){return this.renderer.shownFields(this.store.state)}isThere(e){if(this.live)return this.live.shownFrame===this.store.state.frame;let t=J(this.store.state);try{return this.shown().every(n=>this.frames.get(n,this.renderer.frameOf(n,e),t)!==null)}catch{return!0}}tick(e){if(requestAnimationFrame(e=>this.tick(e)),this.headset.isOn||(this.timeline.tick(e),this.fitCanvas()&&(this.wanted=!0),!this.wanted&&!this.pace.rests()))return;this.wanted=!1;let t=this.pace.draws(e,this.moved);this.moved=!1,this.draw(this.store.state.show===`eye`?t:1)}drawHeadset(e,t,n){this.timeline.tick(e);let{state:r}=this.store;this.frames.pin(this.shown(),r.frame),this.renderer.drawHeadset(r,t,n,this.ground()),this.prefetch()}hearOfHeadset(){let e=this.headset?.isOn??!1;Q(`stage`).dataset.headset=String(e),this.notify(`in headset`,e?`The headset shows the light field, and this page waits. Leave VR comes back to it.`:``),this.updateControls(),this.redraw()}ground(){return this.store.state.theme===`light`?[.93,.93,.93]:[.055,.055,.06]}fitCanvas(){if(document.body.classList.toggle(`plays`,this.player.isPlaying),this.player.isPlaying){let e=this.player.fit(this.canvas);return this.renderer.screen=[this.canvas.width,this.canvas.height],e}this.canvas.style.width=this.canvas.style.height=``,this.notify(`screen`,``);let e=Math.min(window.devicePixelRatio||1,2),t=Math.max(1,Math.round(this.canvas.clientWidth*e)),n=Math.max(1,Math.round(this.canvas.clientHeight*e)),[r,i]=this.renderer.screen;return this.renderer.screen=[t,n],r!==t||i!==n}draw(t=1){let{state:n}=this.store;document.documentElement.dataset.theme=n.theme,this.frames.pin(this.shown(),n.frame),this.renderer.loupe=n.show===`panel`?this.pointer:null;let r=!1;try{r=this.renderer.draw(n,this.ground(),t),this.notify(`frame`,``)}catch(t){if(!(t instanceof e))throw t;this.notify(`frame`,t.message),r=!0}Q(`bar`).hidden=r,Q(`stage`).dataset.drawn=String(r&&t===1&&!this.frames.isAsking),Q(`stage`).dataset.divisor=String(t),Q(`stage`).dataset.frame=r?String(this.live?.shownFrame??n.frame):``,this.canvas.setAttribute(`aria-label`,this.spoken()),r&&(this.showZone(),this.showValues(),this.showScale(),this.showOrigins(),this.showLine(),this.prefetch())}spoken(){let{state:e}=this.store;return`${this.fields[0].title}, frame ${this.fields[0].frames[e.frame].label}: ${this.shownText()}`}shownText(){let{state:e}=this.store;if(e.show===`display`)return`played on ${this.player.describe()}. F fills the screen, ${this.live?`arrow keys do what dragging does, `:``}space plays.`;let t=e.eye.map(e=>e.toFixed(0)).join(`, `);return`${e.show===`panel`?`what the panel shows`:`seen from ${t} millimetres`}. Arrow keys move the eye, space plays.`}async prefetch(){if(this.prefetching||this.live)return;this.prefetching=!0;let{state:e}=this.store,t=J(e),n=this.fields[0].frames.length,r=Math.min(n,this.frames.roomFor(0,t)),i=e.frame;for(let a=1;a<r&&e.frame===i;a++)for(let e of this.shown())await(await this.frames.load(e,this.renderer.frameOf(e,(i+a)%n),t))?.whole;this.prefetching=!1,e.frame!==i&&this.redraw()}showLine(){let{state:e}=this.store,t=Q(`line`);if(t.hidden=e.line<0||e.show!==`eye`,t.hidden)return;let{left:n,top:r,width:i,height:a}=this.renderer.place,o=this.canvas.clientWidth/this.renderer.screen[0];t.style.left=`${this.canvas.offsetLeft+n*o}px`,t.style.top=`${this.canvas.offsetTop+(r+e.line*a)*o}px`,t.style.width=`${i*o}px`}showZone(){let{state:e}=this.store,t=this.fields[this.shown()[0]],n=e.show===`eye`?ie(t,e.eye):0,r={stays:`the outermost views`,repeats:`the views of the next cone`,"next lens":`the pictures of neighbouring lenses`}[t.across.beyond];this.notify(`zone`,n>0?`This eye is out of the viewing zone of ${Math.max(1,Math.round(100*n))}\u2009% of the display: there it sees ${r}.`:``)}showScale(){let{state:e}=this.store,t=Q(`scale`);if(t.hidden=this.shown().length<2||e.compare!==`difference`,t.hidden)return;let n=this.difference();t.textContent=``;let r=document.createElement(`span`);r.textContent=`0 to ${Math.round(e.scale)} codes`;let i=document.createElement(`span`);i.textContent=n===1/0?`identical`:`${n.toFixed(2)} dB`;let a=document.createElement(`i`);t.append(a,r,i),this.fields[0].frames[e.frame].psnr_db===void 0&&this.timeline.psnr[e.frame]!==n&&(this.timeline.psnr[e.frame]=n,this.timeline.update())}showOrigins(){let{state:e}=this.store,t=e.show===`display`?`none`:e.overlay;Dt(Q(`legend`),this.fields[this.shown()[0]],t,t===`none`?null:this.renderer.originShares(e))}difference(){let[e,t]=[0,1].map(e=>this.renderer.picture({...this.store.state,overlay:`none`},e,m(this.fields[0])));if(!e||!t)return NaN;let n=0;for(let r=0;r<e.length;r++)n+=(e[r]-t[r])**2;return n===0?1/0:10*Math.log10(255**2*.75*e.length/n)}showValues(){let{state:e}=this.store,t=Q(`values`),n=this.pointer&&this.renderer.shareAt(e,this.pointer.x,this.pointer.y);if(!n||e.show===`display`){t.value=``;return}let r=this.fields[this.shown()[0]],i=e.show===`panel`?r.panel.size:m(r),a=[`${Math.floor(n[0]*i[0])}, ${Math.floor(n[1]*i[1])}`];if(this.shown().forEach((t,r)=>{let i=this.renderer.valueAt(r,n);a.push(i.map(t=>String(vt(t*2**e.exposure)).padStart(3,` `)).join(` `)),this.shown().length===1&&a.push(i.map(e=>e.toFixed(3)).join(` `))}),r.depth&&e.show===`eye`&&this.shown().length===1){let t=this.renderer.depthAt(e,n);t!==null&&Math.abs(t)<1e4&&a.push(`z ${t.toFixed(1)} mm`)}t.value=a.join(`   `)}focusRange(){let e=this.fields[0],{state:t}=this.store,n=this.frames.peek(0,t.frame,J(t));if(!n)return[-50,50];let r=e.vergence_per_mm>0?.8/e.vergence_per_mm:1/0,i=e.vergence_per_mm>0?-2/e.vergence_per_mm:-1/0,[a,o]=n.disparities.map(t=>{let n=1+t*e.vergence_per_mm>.02?ee(e,t):-1/0;return Math.min(Math.max(n,i),r)});return[Math.min(a,t.focus),Math.max(o,t.focus,a+1)]}at(e){let t=this.canvas.getBoundingClientRect(),[n,r]=this.renderer.screen;return{x:(e.clientX-t.left)/t.width*n,y:(e.clientY-t.top)/t.height*r}}listen(){let{canvas:t}=this,n=null,r=new Set,i=()=>{n?.moved&&this.dragTo(n,n),n=null};t.addEventListener(`pointerdown`,e=>{if(r.add(e.pointerId),r.size>1)return i();t.setPointerCapture(e.pointerId);let a=this.at(e);n={...a,finger:e.pointerId,shares:this.shares(),moved:!1,what:this.graspedAt(a.x,a.y),orbit:this.live?M(this.live):[0,0],plane:this.live?P(this.live):1}}),t.addEventListener(`pointermove`,e=>{let t=this.at(e);this.pointer=t,this.redraw(),n&&n.finger===e.pointerId&&(Math.hypot(t.x-n.x,t.y-n.y)>4&&(n.moved=!0),n.moved&&this.dragTo(n,t))}),t.addEventListener(`pointerup`,e=>{r.delete(e.pointerId),n&&!n.moved&&this.clickAt(this.at(e)),e.pointerType!==`mouse`&&(this.pointer=null),n=null,this.redraw()}),t.addEventListener(`pointercancel`,e=>{r.delete(e.pointerId),i()}),t.addEventListener(`pointerleave`,()=>{this.pointer=null,this.redraw()}),t.addEventListener(`wheel`,e=>this.wheel(e),{passive:!1}),t.addEventListener(`webglcontextlost`,t=>{t.preventDefault(),Wn(new e(`The browser has taken the graphics away, for want of memory perhaps. Reload the page.`))}),window.addEventListener(`keydown`,e=>this.key(e)),window.addEventListener(`click`,e=>{e.detail>0&&e.target instanceof Element&&e.target.closest(`button`)&&t.focus({preventScroll:!0})}),window.addEventListener(`hashchange`,()=>this.store.readAddress());let a=Q(`toggle`);a.addEventListener(`click`,()=>{let e=document.body.classList.toggle(`open`);a.setAttribute(`aria-expanded`,String(e))})}shares(){let{eye:e}=this.store.state,t=this.fields[0];return[f(t.across,e[0]/e[2]),f(t.up,e[1]/e[2])]}graspedAt(e,t){let{state:n}=this.store,{left:r,top:i,width:a,height:o}=this.renderer.place,s=14*(this.renderer.screen[0]/this.canvas.clientWidth);return this.shown().length>1&&n.compare===`wipe`&&Math.abs(e-r-n.wipe*a)<s?`wipe`:n.line>=0&&Math.abs(t-i-n.line*o)<s?`line`:this.live?n.drag:`eye`}dragTo(e,t){let{left:n,top:r,width:i,height:a}=this.renderer.place;e.what===`wipe`?this.store.set({wipe:(t.x-n)/i}):e.what===`line`?this.store.set({line:Math.min(Math.max((t.y-r)/a,0),1)}):this.live&&e.what===`turn`?N(this.live,e.orbit[0]-180*(t.x-e.x)/i,e.orbit[1]+90*(t.y-e.y)/a):this.live&&e.what===`plane`?this.movePlane(e.plane,(e.y-t.y)/a):this.store.state.show===`eye`&&this.moveEye(e.shares[0]+(t.x-e.x)/i,e.shares[1]-(t.y-e.y)/a)}movePlane(e,t){if(!this.live?.state?.plane)return;let[n,r]=ye(this.live);be(this.live,Math.min(Math.max(e+t*(r-n),n),r))}moveEye(e,t){let{eye:n}=this.store.state,r=this.fields[0],i=e=>Math.min(Math.max(e,0),1),a=r.across.views>1?d(r.across,i(e))*n[2]:n[0],o=r.up.views>1?d(r.up,i(t))*n[2]:n[1];this.store.set({eye:[a,o,n[2]]})}clickAt(e){let{state:t}=this.store,n=this.renderer.shareAt(t,e.x,e.y);if(n&&t.show===`eye`){if(this.print?.awaitsClick)return this.putZeroPlaneAt(n);this.live&&t.drag===`turn`||(this.live&&t.drag===`plane`?this.putPlaneAt(n):this.focusAt(n))}}putPlaneAt(e){let t=this.renderer.depthAt(this.store.state,e);t!==null&&Number.isFinite(t)&&this.live?.setPlane(t)}putZeroPlaneAt(e){let t=this.renderer.depthAt(this.store.state,e);t!==null&&Number.isFinite(t)&&this.print?.setPlane(t)}focusAt(e){let{state:t}=this.store,n=this.renderer.depthAt(t,e);n!==null&&this.store.set({focus:n,aperture:t.aperture>0?t.aperture:.5})}wheel(e){if(e.ctrlKey)return;if(e.preventDefault(),this.live&&this.store.state.drag===`turn`)return ve(this.live,this.live.number(`zoom`,1)*2**(-Math.sign(e.deltaY)/8));let{eye:t}=this.store.state,n=2**(Math.sign(e.deltaY)/16),r=this.fields[0].eye_mm[2],i=Math.min(Math.max(t[2]*n,r/4),r*4);this.store.set({eye:[t[0]/t[2]*i,t[1]/t[2]*i,i]})}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let t=e.shiftKey?.01:.05,[n,r]=this.shares(),i={ArrowLeft:()=>this.arrow(n-t,r,-1,0),ArrowRight:()=>this.arrow(n+t,r,1,0),ArrowUp:()=>this.arrow(n,r+t,0,-1),ArrowDown:()=>this.arrow(n,r-t,0,1),Home:()=>this.moveEye(.5,.5)," ":()=>this.timeline.toggle(),",":()=>this.timeline.step(-1),".":()=>this.timeline.step(1),f:()=>this.player.isPlaying?void this.player.toggleFullScreen():this.focusAt([.5,.5]),a:()=>this.store.set({aperture:this.store.state.aperture>0?0:.5}),p:()=>this.store.set({show:this.store.state.show===`panel`?`eye`:`panel`})}[e.key.length===1?e.key.toLowerCase():e.key];i&&!Gn(e)&&(e.preventDefault(),i())}arrow(e,t,n,r){let{show:i,drag:a}=this.store.state;if(i!==`panel`&&this.live&&a===`turn`)return N(this.live,M(this.live)[0]+5*n,M(this.live)[1]-5*r);if(i!==`panel`&&this.live&&a===`plane`)return this.movePlane(P(this.live),-.02*r);if(i===`eye`&&this.moveEye(e,t),i!==`panel`)return;let{left:o,top:s,width:c,height:l}=this.renderer.place,u=this.pointer??{x:o+c/2,y:s+l/2};this.pointer={x:Math.min(Math.max(u.x+n*8,o),o+c),y:Math.min(Math.max(u.y+r*8,s),s+l)},this.redraw()}async picture(t,n=0){let{state:r}=this.store;await(await this.frames.load(n,this.renderer.frameOf(n,r.frame),J({...r,show:`eye`})))?.whole;let i=this.renderer.picture(r,n,t);if(!i)throw new e(`The frame is not there yet.`);return i}panelCodes(){return this.fitCanvas(),this.draw(),this.renderer.canvasCodes()}savePicture(){this.draw(),this.canvas.toBlob(e=>{if(!e)return;let t=document.createElement(`a`);t.href=URL.createObjectURL(e),t.download=`${this.fields[0].title}-${this.fields[0].frames[this.store.state.frame].label}.png`,t.click(),URL.revokeObjectURL(t.href)})}async copyLink(){let e=location.href.split(`#`)[0]+this.store.address();try{await navigator.clipboard.writeText(e),this.notify(`link`,`The link is in the clipboard.`)}catch{location.hash=this.store.address(),this.notify(`link`,`The link stands in the address bar.`)}window.setTimeout(()=>this.notify(`link`,``),3e3)}};function qn(e){let{store:t}=e;window.lippmann={get state(){return structuredClone(t.state)},fields:e.fields,set:e=>t.set(e),focusAt:(t,n)=>e.focusAt([t,n]),picture:(t,n,r=0)=>e.picture([t,n],r),get outOfZone(){return ie(e.fields[0],t.state.eye)},get isPlaying(){return e.timeline.playing},pause:()=>e.timeline.pause(),panel:()=>e.panelCodes(),valueAt:(t,n)=>e.renderer.valueAt(0,[t,n]),get scene(){return structuredClone(e.live?.state??null)},get run(){return structuredClone(e.run?.state??null)},setUp:t=>e.live?.set(t),get print(){return structuredClone(e.print?.made??null)}},window.addEventListener(`message`,e=>{let n=e.data?.lippmann;e.source===window.parent&&typeof n==`object`&&n&&t.set(n)}),window.parent!==window&&t.listen(()=>window.parent.postMessage({lippmann:{state:structuredClone(t.state)}},`*`))}async function Jn(){try{let e=await le(),t=e,n=t?.drops===!0;if(n&&t?.fields?.length===0)return void new rt(document.getElementById(`failure`));let r=c(e),{display:i,live:a,run:o,prints:s}=e,l=i??a?.display;qn(new Kn(r,l?ct(l):null,a??null,o??null,{prints:s??null,drops:n}))}catch(t){if(Wn(t),!(t instanceof e))throw t}}Jn()})();